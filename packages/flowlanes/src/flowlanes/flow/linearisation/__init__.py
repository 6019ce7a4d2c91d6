"""Linear equations near a motion: eigenvalues of steady motions, tangent vectors, scales."""
