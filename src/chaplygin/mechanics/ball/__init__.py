"""A homogeneous ball that rolls on a surface."""
