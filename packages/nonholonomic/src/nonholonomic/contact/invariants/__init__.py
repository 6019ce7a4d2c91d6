"""Laws of bodies that slide with friction, in the form in which they are proved."""
