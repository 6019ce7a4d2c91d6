"""The claim of a certificate, and its residuals as numbers at a point."""
