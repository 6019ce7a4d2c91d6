"""Bodies, programs and comparisons of `engine.py`."""
