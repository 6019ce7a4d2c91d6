"""The tables of experiment files, and the messages about mistakes in them."""
