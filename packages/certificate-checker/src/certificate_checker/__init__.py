"""An independent checker of certificates.

A certificate says what is claimed of a system and why it is so: proofs in polynomials, or a point
at which the claim fails.  This package reads it with its own parser, evaluates the claim with its
own arithmetic and computes every identity of polynomials; it shares no code with what made the
certificate, and needs nothing but FLINT.

On the command line::

    python -m certificate_checker FILE…

That polynomials are those of the formulas is tested modulo a random prime, with a probability of an
error below 2^−100 (see :mod:`certificate_checker.identities.residues` and
:mod:`certificate_checker.identities.error_bound`); everything else is computed exactly.
"""

from __future__ import annotations

from .certificate import FORMAT, check
from .claim.errors import BadInputError, CheckError

__all__ = ["FORMAT", "BadInputError", "CheckError", "check"]
