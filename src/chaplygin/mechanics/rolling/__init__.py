"""A body of any smooth convex shape that rolls on a plane or a sphere."""
