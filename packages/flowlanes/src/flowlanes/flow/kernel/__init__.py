"""Generation of machine code for integrators."""
