"""What every figure is drawn with: the canvas, its style, geometry, files."""
