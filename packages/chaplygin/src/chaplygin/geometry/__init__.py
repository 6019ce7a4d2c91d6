"""Bodies and surfaces of space as polygons and functions, for pictures and pages."""
