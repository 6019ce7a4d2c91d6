"""The claim of a certificate, and its residuals evaluated at a point."""
