"""New kinds, each in one file, with no change anywhere else."""
