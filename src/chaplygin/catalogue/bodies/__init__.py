"""Bodies that are no balls, or whose centre of mass is not in their centre, on a plane."""
