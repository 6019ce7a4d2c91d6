"""Systems, the laws claimed of them, and 3-vectors: the objects that everything else uses."""
