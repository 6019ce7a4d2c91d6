"""Simulation of a motion with friction, from one contact event to the next."""
