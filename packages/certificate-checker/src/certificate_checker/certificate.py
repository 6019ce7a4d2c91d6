"""Check of a whole certificate: the claim, and its proofs or its witness."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping

from .certificate_points import check_sample, check_witness
from .claim.claim import Claim, read_claim
from .claim.errors import BadInputError, CheckError, UndefinedError
from .claim.formulas import names_in
from .claim.json_data import as_list, field, mapping, only, text
from .claim.parsing import parse_condition
from .claim.power import claims_of_identities
from .claim.separation import check_separation
from .identities.basis import Basis
from .identities.proof import Condition, check_proof
from .identities.signs import covers

FORMAT = "chaplygin certificate 2"


def check(certificate: object) -> None:
    """Check a certificate.

    Parameters
    ----------
    certificate : mapping
        As returned by ``json.load``.

    Raises
    ------
    BadInputError
        If the data are not a certificate.
    CheckError
        If the certificate is not valid; the message is one sentence with the reason.

    Examples
    --------
    >>> import certificate_checker
    >>> claim = {
    ...     "system": {
    ...         "name": "oscillator",
    ...         "state": ["x", "v"],
    ...         "rates": ["v", "-x"],
    ...         "definitions": [],
    ...         "parameters": [],
    ...         "relations": [],
    ...         "guards": [],
    ...         "admissible": [],
    ...     },
    ...     "law": {"kind": "Integral", "name": "x", "on": [], "value": "x"},
    ... }
    >>> witness = {"point": {"x": "1", "v": "2"}, "what": "v(F)", "index": 0, "residual": "2"}
    >>> certificate_checker.check(
    ...     {
    ...         "format": certificate_checker.FORMAT,
    ...         "verdict": "refuted",
    ...         "claim": claim,
    ...         "witness": witness,
    ...     }
    ... )
    """
    if not isinstance(certificate, Mapping) or certificate.get("format") != FORMAT:
        raise BadInputError(f"this is not a certificate of the format {FORMAT!r}")
    try:
        _check(certificate)
    except UndefinedError as error:
        raise CheckError(f"something is not defined: {error}") from None
    except RecursionError:
        raise CheckError("a formula or a tree is nested too deep") from None


def _check(data: Mapping[str, object]) -> None:
    what = "the certificate"
    claim = read_claim(field(data, "claim", what), "the claim")
    verdict = field(data, "verdict", what)
    if verdict == "refuted":
        only(data, what, "format", "verdict", "claim", "witness")
        check_witness(claim, field(data, "witness", what))
        return
    if verdict not in ("proven", "proven where"):
        raise CheckError(f"the verdict {verdict!r} is not allowed in a certificate")
    allowed = ["format", "verdict", "claim", "proofs", "sample"]
    conditions: list[Condition] = []
    if verdict == "proven where":
        allowed.append("conditions")
        stated = as_list(field(data, "conditions", what), f"the conditions of {what}")
        conditions = [_condition(t, claim) for t in stated]
        if not conditions:
            raise CheckError("the verdict is 'proven where', but there are no conditions")
    # The random points are derived from the whole certificate, so that they cannot be known before
    # it is written (see :mod:`.identities.error_bound`).
    seed = hashlib.sha256(json.dumps(data, sort_keys=True, default=repr).encode()).hexdigest()
    if "rates" in data:
        only(data, what, "format", "verdict", "claim", "sample", "rates", "identities")
        check_sample(claim, field(data, "sample", what), conditions)
        _check_identities(data, claim, seed)
        return
    only(data, what, *allowed)
    if claim.law.kind == "Separation":
        check_separation(claim)
    check_sample(claim, field(data, "sample", what), conditions)
    _check_proofs(data, claim, conditions, seed)


def _check_identities(data: Mapping[str, object], claim: Claim, seed: str) -> None:
    """Check the identities with which the theorem on energy proves an integral."""
    what = "the identities"
    stated = mapping(field(data, "claim", "the certificate"), "the claim")
    claims = claims_of_identities(stated, claim, data["rates"])
    identities = mapping(field(data, "identities", "the certificate"), what)
    only(identities, what, *claims)
    for word, whole in claims.items():
        identity = mapping(field(identities, word, what), f"the identity {word!r}")
        only(identity, f"the identity {word!r}", "sample", "proofs")
        own = read_claim(whole, f"the claim {word!r}")
        check_sample(own, field(identity, "sample", f"the identity {word!r}"), [])
        _check_proofs(identity, own, [], f"{seed} {word}")


def _condition(data: object, claim: Claim) -> Condition:
    """Condition such as ``x > 0``, ``not x = 0`` or ``x != 0``."""
    words = text(data, "a condition")
    negated = words.startswith("not ")
    relation = words
    if negated:
        relation = words.removeprefix("not ").replace("=", "==") if "==" not in words else words[4:]
    parts = parse_condition(relation, "a condition")
    allowed = {(True, "="), (False, ">"), (False, "!=")}
    if len(parts) != 1 or (negated, parts[0][1]) not in allowed:
        raise CheckError(f"the condition {words!r} is neither x > 0 nor x != 0")
    formula, sign = parts[0]
    if not names_in([formula]) <= {*claim.system.symbols, *claim.system.definitions}:
        raise CheckError(f"the condition {words!r} uses an unknown symbol")
    return Condition(words, formula, sign == ">")


def _check_proofs(
    data: Mapping[str, object], claim: Claim, conditions: list[Condition], seed: str
) -> None:
    """Check every proof, and that together they cover all combinations of assumed signs."""
    proofs = as_list(field(data, "proofs", "the certificate"), "proofs")
    if not proofs:
        raise CheckError("the certificate has no proofs")
    # Proofs can be combined only if they make the same assumptions about vanishing functions.
    groups: dict[str, list[Basis]] = {}
    for i, data_of_one in enumerate(proofs):
        what = f"proof {i}"
        proof = mapping(data_of_one, what)
        basis = check_proof(proof, claim, what, conditions, seed)
        groups.setdefault(json.dumps(proof.get("zeros", [])), []).append(basis)
    if not any(covers(group, conditions) for group in groups.values()):
        raise CheckError("the proofs do not cover all signs")
