"""The tables of experiment files, and the sentences about mistakes in them."""
