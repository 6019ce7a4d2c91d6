"""Whether an invariant measure exists whose density depends on the configuration alone."""
