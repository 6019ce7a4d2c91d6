"""Bodies that turn about a fixed point: Suslov, Veselova, Neumann, Clebsch, Lagrange."""
