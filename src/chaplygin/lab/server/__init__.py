"""The laboratory as a server for one user: what pages ask that only Python can compute."""
