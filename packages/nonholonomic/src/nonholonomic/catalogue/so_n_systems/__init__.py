"""Balls, Veselova's top and Suslov's problem in n dimensions, n = 3 to 9."""
