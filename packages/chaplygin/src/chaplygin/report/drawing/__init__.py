"""Tools of all figures: canvas, style, files."""
