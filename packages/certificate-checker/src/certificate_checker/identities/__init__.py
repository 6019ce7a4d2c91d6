"""The identities by which a certificate says that residuals vanish."""
