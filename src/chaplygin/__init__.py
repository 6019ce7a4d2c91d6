"""A laboratory for the nonholonomic mechanics of rolling bodies."""
