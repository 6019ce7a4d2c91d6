"""The course of a motion with friction, from one event to the next."""
