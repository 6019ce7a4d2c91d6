"""Machine code for integration: its generation, its compilation, its cache."""
