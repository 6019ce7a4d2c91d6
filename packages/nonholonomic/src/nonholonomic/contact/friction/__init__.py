"""Laws of friction, and the modes of a contact in which they act."""
