"""What `engine.py` compares: bodies, programs, and how they are made to meet."""
