"""What a certificate claims, and its residuals as numbers at a point."""
