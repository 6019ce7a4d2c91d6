"""Certificates: what another program needs in order to check a verdict.

A certificate of a proof holds the equations of the system, the law, the ring, the relations with
their quotients, and every residual as an identity of polynomials

    multiplier · numerator = Σ quotient_i · relation_i,

where the residual is numerator / ∏ factor^power.  Polynomials are lists of pairs: a coefficient
and the powers of the generators of the ring, ``[generator, exponent, …]``.
A certificate of a refutation holds the point and the residual there.
"""

from __future__ import annotations

import random
import time
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

from ..errors import InputError
from ..statements import Law
from ..system import System
from .budget import Budget
from .errors import SpareNeededError
from .functions import Fractions
from .ground import Ground
from .numbers import precise
from .prove import everything, prove, standing, tried
from .verdict import Verdict

__all__ = ["certified", "check"]


class _Unreduced(Fractions):
    """Fractions whose numerators are kept as they come, so that the quotients can be given."""

    def reduce(self, poly: Any) -> Any:
        """Nothing is reduced."""
        return poly

    def vanishes(self, element: Any) -> bool:
        """Whether an element is zero modulo the relations, the numerator staying as it is."""
        return not element.poly or not self.divided(element.poly)[2]

    def divided(self, poly: Any) -> tuple[Any, list[Any], Any]:
        """Multiplier, quotients by the relations and remainder."""
        multiplier = self.ring.constant(1)
        quotients = [self.ring.constant(0) for _ in self._chain]
        for main, _, _ in (("", None, None), *self._chain):
            if main:
                poly, factor, quotients = self._pseudo_divided(poly, quotients, main)
                multiplier = multiplier * factor
            poly = self._divided_by_leads(poly, quotients)
        return multiplier, quotients, poly

    def _divided_by_leads(self, poly: Any, quotients: list[Any]) -> Any:
        while poly:
            before = poly
            for i, (_, relation, _) in enumerate(self._chain):
                quotient, poly = divmod(poly, relation)
                quotients[i] = quotients[i] + quotient
            if poly == before:
                break
        return poly

    def _pseudo_divided(
        self, poly: Any, quotients: list[Any], main: str
    ) -> tuple[Any, Any, list[Any]]:
        index = next(i for i, (name, _, _) in enumerate(self._chain) if name == main)
        relation = self._chain[index][1]
        position = self.names.index(main)
        degree = int(relation.degrees()[position])
        lead = self.coefficient(relation, position, degree)
        total = self.ring.constant(1)
        while poly and (height := int(poly.degrees()[position])) >= degree:
            top = self.coefficient(poly, position, height)
            step = top * self.generators[main] ** (height - degree)
            poly = lead * poly - step * relation
            quotients = [lead * q for q in quotients]
            quotients[index] = quotients[index] + step
            total = total * lead
        return poly, total, quotients


def certified(system: System, law: Law, seconds: float = 300.0) -> Verdict:
    """Prove or refute a law, with a certificate.

    Raises
    ------
    InputError
        As for :func:`chaplygin.laws.prove.prove`.
    """
    verdict = prove(system, law, seconds=seconds)
    before: list[tuple[System, Law]] = []
    if verdict.decision != "undecided":
        *before, (system, law) = standing(system, law)
    content: dict[str, Any] = {"verdict": verdict.decision, **_statement(system, law)}
    if verdict.decision == "refuted":
        content["witness"] = verdict.witness
    elif verdict.decision == "proven":
        content |= _identities(Ground(system, law.on), law, seconds)
        content["before"] = [
            _statement(*claim) | _identities(Ground(claim[0], claim[1].on), claim[1], seconds)
            for claim in before
        ]
    else:
        content["reason"] = verdict.reason
    return replace(verdict, certificate=content)


def _statement(system: System, law: Law) -> dict[str, Any]:
    """The system and the law as text that SymPy reads."""
    parts = {n: v for n, v in vars(law).items() if n not in ("as_printed", "misprint")}
    return {
        "system": system.name,
        "field": {str(s): str(r) for s, r in zip(system.symbols, system.rates, strict=True)},
        "definitions": {str(s): str(e) for s, e in system.steps},
        "relations": [str(c) for c in Ground(system, law.on).conditions],
        "law": {"kind": type(law).__name__, **{n: _text(v) for n, v in parts.items()}},
    }


def _text(value: Any) -> Any:
    if isinstance(value, System):
        return {
            "name": value.name,
            **{str(s): str(r) for s, r in zip(value.symbols, value.rates, strict=True)},
        }
    if isinstance(value, tuple):
        return [_text(part) for part in value]
    if isinstance(value, Law):
        return {n: _text(v) for n, v in vars(value).items()}
    return str(value)


def _identities(ground: Ground, law: Law, seconds: float) -> dict[str, Any]:
    with precise():
        field, _ = tried(law, ground, random.Random(1))
    sample = {name: float(value) for name, value in field.values.items()}
    spare = 8
    while True:
        budget = Budget(deadline=time.monotonic() + seconds)
        ring = ground.fractions(_Unreduced, spare, sample, budget)
        try:
            residuals = list(everything(law, ground, ring))
        except SpareNeededError:
            spare *= 2
            continue
        return {
            "ring": list(ring.names),
            "exchanged": {
                str(e.name): f"{e.factor}*{e.parameter} + {e.rest}" for e in ground.exchanged
            },
            "inverted": {
                str(a): str(j) for i in ground.inverted for a, j in zip(i.name, i.of, strict=True)
            },
            "settled": {str(p): str(v) for p, v in ground.settled.items()},
            "auxiliary": ring.meanings,
            "conditions": [_terms(relation) for _, relation, _ in ring.relations],
            "residuals": [_identity(ring, what, residual) for what, residual in residuals],
        }


def _identity(ring: _Unreduced, what: str, residual: Any) -> dict[str, Any]:
    multiplier, quotients, rest = ring.divided(residual.poly)
    if rest:
        raise InputError(f"no certificate: {what} leaves a remainder")
    return {
        "what": what,
        "numerator": _terms(residual.poly),
        "denominator": [[_terms(ring.factors[n]), -p] for n, p in residual.powers.items()],
        "multiplier": _terms(multiplier),
        "quotients": [_terms(q) for q in quotients],
    }


def _terms(poly: Any) -> list[Any]:
    """A polynomial as pairs of a coefficient and the powers [generator, exponent, …]."""
    return [
        [str(number), [x for i, n in enumerate(exponents) if n for x in (i, int(n))]]
        for exponents, number in poly.to_dict().items()
    ]


def check(certificate: Mapping[str, Any]) -> bool:
    """Whether the identities of a certificate of a proof hold, as polynomials.

    This reads the certificate alone and uses SymPy's polynomials, not the arithmetic of the
    prover.
    """
    ring = PolyRing(certificate["ring"], sp.QQ, sp.lex)

    def poly(terms: list[Any]) -> Any:
        made = {}
        for number, powers in terms:
            exponents = [0] * len(ring.symbols)
            for i, n in zip(powers[::2], powers[1::2], strict=True):
                exponents[i] = n
            made[tuple(exponents)] = sp.QQ(*map(int, f"{number}/1".split("/")[:2]))
        return ring.from_dict(made)

    conditions = [poly(terms) for terms in certificate["conditions"]]
    for item in certificate["residuals"]:
        multiplier = poly(item["multiplier"])
        total = multiplier * poly(item["numerator"])
        for quotient, condition in zip(item["quotients"], conditions, strict=True):
            total = total - poly(quotient) * condition
        if total or not multiplier:
            return False
    return all(check(part) for part in certificate.get("before", ()))
