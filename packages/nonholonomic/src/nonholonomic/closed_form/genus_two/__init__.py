"""Systems that separate on a curve of genus two: theta functions and reconstruction."""
