"""Convex bodies by the inverse of their Gauss map, and the surfaces on which they roll."""
