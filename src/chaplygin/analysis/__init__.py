"""Analysis of the dynamics: Lyapunov exponents, orbits, scans, classification."""
