"""What a system can do: its place in the hierarchy of dynamics."""
