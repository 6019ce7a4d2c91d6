"""Bodies on a plane that are not balls, and balls with displaced centre of mass."""
