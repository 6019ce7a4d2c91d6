"""Homogeneous balls that roll on surfaces other than planes and spheres."""
