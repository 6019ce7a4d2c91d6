"""The trajectory of a motion with friction, and its dataset."""
