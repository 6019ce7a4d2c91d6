"""What all closed forms have in common: the problem, the solution, the refusal."""
