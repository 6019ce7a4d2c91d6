"""Bodies and balls of n-dimensional space, n = 3 to 9, whose angular velocity is a skew matrix."""
