"""Tools of all figures: canvas, style, geometry, files."""
