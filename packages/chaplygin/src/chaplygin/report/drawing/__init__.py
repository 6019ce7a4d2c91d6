"""Tools shared by all figures: canvas, style, files."""
