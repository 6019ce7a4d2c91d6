"""Base classes for closed forms: the problem, the solution, the refusal."""
