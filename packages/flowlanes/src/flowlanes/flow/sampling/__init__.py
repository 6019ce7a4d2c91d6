"""Points drawn from a level of integrals, by its invariant measure."""
