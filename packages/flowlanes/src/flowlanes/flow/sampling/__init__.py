"""Random points on a level of integrals, distributed by its invariant measure."""
