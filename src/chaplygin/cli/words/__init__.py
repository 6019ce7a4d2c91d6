"""What commands say: of the results of a run, and of mistakes in a command line."""
