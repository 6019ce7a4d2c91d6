"""From what one can touch (a body, a surface, a contact) to a System."""
