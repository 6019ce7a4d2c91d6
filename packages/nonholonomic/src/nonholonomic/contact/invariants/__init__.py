"""Laws of bodies that slide with friction, in a form that can be proved."""
