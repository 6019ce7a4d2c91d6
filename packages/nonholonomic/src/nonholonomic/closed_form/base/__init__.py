"""The base of all closed forms: the problem, the solution, the refusal."""
