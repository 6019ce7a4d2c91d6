"""Lyapunov exponents and other indicators of chaos."""
