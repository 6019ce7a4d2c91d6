"""Models of `sympy.physics.mechanics` as Systems."""
