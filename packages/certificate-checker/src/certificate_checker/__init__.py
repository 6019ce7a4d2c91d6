"""An independent checker of certificates.

A certificate states a claim about a system and the reason for it: proofs in terms of polynomials,
or a point at which the claim fails.  This package reads it with its own parser, evaluates the claim
with its own arithmetic and verifies every polynomial identity.  It shares no code with the prover,
and needs nothing but FLINT.

On the command line::

    python -m certificate_checker FILE…

That the polynomials represent the formulas is tested modulo a random prime, with an error
probability below 2^−100 (see :mod:`certificate_checker.identities.residues` and
:mod:`certificate_checker.identities.error_bound`); everything else is computed exactly.
"""

from __future__ import annotations

from .certificate import FORMAT, check
from .claim.errors import BadInputError, CheckError

__all__ = ["FORMAT", "BadInputError", "CheckError", "check"]
