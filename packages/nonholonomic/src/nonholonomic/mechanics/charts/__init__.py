"""Coordinates of the states of rigid bodies: Andoyer variables, directions with the energy."""
