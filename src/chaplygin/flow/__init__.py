"""One door to numbers: trajectories of a System, compiled once and cached."""
