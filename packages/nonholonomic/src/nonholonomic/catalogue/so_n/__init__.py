"""Bodies of n-dimensional space: inertia, starts, motion in space, and laws of all n."""
