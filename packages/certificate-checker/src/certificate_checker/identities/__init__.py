"""The identities by which a certificate shows that residuals vanish."""
