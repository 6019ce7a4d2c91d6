"""Contact with friction: its laws, its transitions, flight and impact."""
