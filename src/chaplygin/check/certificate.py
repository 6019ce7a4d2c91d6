"""Certificates as a whole: what is claimed, by which proofs or by which witness."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from functools import partial

from .certificate_points import check_sample, check_witness
from .claim.claim import Claim, read_claim
from .claim.errors import BadInputError, CheckError, UndefinedError
from .claim.formulas import names_in, parse, parse_condition
from .claim.json_data import as_list, field, integer, mapping, only, text
from .claim.power import claims_of_identities
from .claim.separation import check_separation
from .identities.accuracy import with_precision
from .identities.basis import Basis, read_basis
from .identities.case_tree import Node, check_tree
from .identities.proof import Condition, check_left, check_proof, read_region, same
from .identities.read_generators import FIELDS, read_generators
from .identities.signs import covers
from .identities.substitution import CONSISTENCY, LAW, expressed_variables, statements

FORMAT = "chaplygin certificate 2"


def check(certificate: object) -> None:
    """Check a certificate.

    Parameters
    ----------
    certificate : mapping
        As :func:`json.load` reads it.

    Raises
    ------
    BadInputError
        If this is no certificate.
    CheckError
        If it does not check: one sentence says what.

    Examples
    --------
    >>> import chaplygin as ch
    >>> veselova = ch.from_catalogue("veselova")
    >>> verdict = ch.proof.prove_with_certificate(veselova, veselova.integrals[0])
    >>> check(verdict.certificate)
    """
    if not isinstance(certificate, Mapping) or certificate.get("format") != FORMAT:
        raise BadInputError(f"this is no certificate of the format {FORMAT!r}")
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
        raise CheckError(f"the verdict {verdict!r} is none that a certificate may have")
    allowed = ["format", "verdict", "claim", "proofs", "cover", "sample"]
    conditions: list[Condition] = []
    if verdict == "proven where":
        allowed.append("conditions")
        stated = as_list(field(data, "conditions", what), f"the conditions of {what}")
        conditions = [_condition(t, claim) for t in stated]
        if not conditions:
            raise CheckError("the verdict is proven where, but no condition says where")
    if "rates" in data:
        only(data, what, "format", "verdict", "claim", "sample", "rates", "identities")
        check_sample(claim, field(data, "sample", what), conditions)
        _check_identities(data, claim)
        return
    only(data, what, *allowed)
    if claim.law.kind == "Separation":
        check_separation(claim)
    check_sample(claim, field(data, "sample", what), conditions)
    _Proofs(data, claim, conditions).check()


def _check_identities(data: Mapping[str, object], claim: Claim) -> None:
    """Check the identities by which the theorem on energy proves an integral."""
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
        _Proofs({**identity, "claim": whole}, own, []).check()


def _condition(data: object, claim: Claim) -> Condition:
    """A condition such as ``x > 0``, ``not x = 0`` or ``x != 0``."""
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


class _Proofs:
    """The proofs of a certificate, each checked, and whether they cover the claim."""

    def __init__(
        self, data: Mapping[str, object], claim: Claim, conditions: Sequence[Condition]
    ) -> None:
        self.data, self.claim, self.conditions = data, claim, conditions
        self.claim_data = field(data, "claim", "the certificate")
        self.proofs = [
            mapping(proof, f"proof {i}")
            for i, proof in enumerate(as_list(field(data, "proofs", "the certificate"), "proofs"))
        ]
        self.bases: list[Basis] = []
        self.roles: list[set[str]] = []

    def check(self) -> None:
        """Check every proof, and that they cover the claim."""
        if not self.proofs:
            raise CheckError("the certificate has no proofs")
        for i, proof in enumerate(self.proofs):
            claim, says = self._claim(proof, f"proof {i}")
            self.roles.append(says)
            self.bases.append(check_proof(proof, claim, f"proof {i}", self.conditions))
        if "cover" not in self.data:
            everywhere = [i for i in range(len(self.proofs)) if not self.proofs[i].get("region")]
            self._require(everywhere, "the proofs")
            return
        self._check_cover(mapping(self.data["cover"], "the cover"))

    def _claim(self, proof: Mapping[str, object], what: str) -> tuple[Claim, set[str]]:
        """The claim that a proof is one of, and what it says of the claim of the user."""
        if not proof.get("substitution"):
            if "claim" in proof and proof["claim"] != self.claim_data:
                raise CheckError(f"{what} is one of another claim")
            return self.claim, {LAW}
        stated = read_claim(field(proof, "claim", what), f"the claim of {what}")
        region = read_region(proof, self.claim, what)
        change = proof["substitution"]
        return stated, statements(self.claim, stated, change, region, self.conditions, what)

    def _require(self, numbers: Sequence[int], what: str) -> None:
        """Some proofs treat everything, whatever signs they assume."""
        groups: dict[str, list[int]] = {}
        for i in numbers:
            groups.setdefault(self._generators_of(i), []).append(i)
        done = [
            chosen
            for chosen in groups.values()
            if covers([self.bases[i] for i in chosen], self.conditions)
        ]
        agreed = {
            expressed_variables(self.proofs[chosen[0]].get("substitution", []))
            for chosen in done
            if CONSISTENCY in self.roles[chosen[0]]
        }
        for chosen in done:
            graph = expressed_variables(self.proofs[chosen[0]].get("substitution", []))
            if LAW in self.roles[chosen[0]] and (not graph or graph in agreed):
                return
        raise CheckError(f"{what} leave open what holds for some signs, or some points")

    def _generators_of(self, number: int) -> str:
        proof = self.proofs[number]
        claim = (
            proof.get("claim", self.claim_data) if proof.get("substitution") else self.claim_data
        )
        return json.dumps([claim, proof.get("substitution", []), proof.get("zeros", [])])

    def _check_cover(self, data: Mapping[str, object]) -> None:
        only(data, "the cover", *FIELDS, "tree")
        if data.get("signs"):
            raise CheckError("the cover assumes signs")
        generators = read_generators(data, self.claim, "the cover")
        basis = with_precision(lambda: read_basis(data, generators, (), "the cover"))

        def leaf(node: Node, data: Mapping[str, object], where: str) -> None:
            if data["case"] != "proof":
                check_left(node, data, where, basis, self.conditions)
                return
            only(data, where, "case", "numbers")
            last = len(self.proofs) - 1
            numbers = [
                integer(n, f"a proof at {where}", 0, last)
                for n in as_list(field(data, "numbers", where), where)
            ]
            for i in numbers:
                self._check_region(i, basis, node, where)
            self._require(numbers, f"the proofs at {where}")

        node = Node(generators.ring, basis.equations, basis.nonzero, basis.signs, None, leaf)
        check_tree(node, field(data, "tree", "the cover"), "the tree of the cover")

    def _check_region(self, number: int, basis: Basis, node: Node, where: str) -> None:
        what = f"the region of proof {number}"
        for words in as_list(self.proofs[number].get("region", []), what):
            formula = parse(words, what)
            if all(
                with_precision(partial(same, basis, equation, formula)) is None
                for equation in node.equations
            ):
                raise CheckError(f"proof {number} treats a smaller part than {where}")
