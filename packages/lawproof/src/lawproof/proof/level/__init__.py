"""The level on which a law is claimed, as a variety: its components, charts and points."""
