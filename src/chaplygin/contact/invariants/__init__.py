"""What friction keeps and what it takes: laws of sliding bodies, for proof."""
