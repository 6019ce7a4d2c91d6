"""Certificates written by hand: polynomials and fractions from texts, claims with few words."""

from __future__ import annotations

import re
from typing import Any

from flint import Ordering, fmpq_mpoly_ctx


def poly(text: str, ring: list[str]) -> list[Any]:
    """A polynomial as a list of terms."""
    context = fmpq_mpoly_ctx.get(ring, Ordering.lex)
    names = dict(zip(ring, context.gens(), strict=True))
    # numbers other than exponents are exact
    exact = re.sub(r"(?<!\*\*)\b\d+\b", lambda digits: f"constant({digits[0]})", text)
    expanded = eval(exact, {"constant": context.constant}, names)
    return [
        [str(c), [x for i, n in enumerate(powers) if n for x in (i, int(n))]]
        for powers, c in expanded.terms()
    ]


def powers(pairs: list[tuple[str, int]], ring: list[str]) -> list[Any]:
    return [[poly(text, ring), power] for text, power in pairs]


def system(state: dict[str, str], **more: Any) -> dict[str, Any]:
    return {
        "name": "made",
        "state": list(state),
        "rates": list(state.values()),
        "definitions": [],
        "parameters": [],
        "relations": [],
        "guards": [],
        "admissible": [],
        **more,
    }


def law(kind: str, on: list[str] | None = None, **fields: Any) -> dict[str, Any]:
    return {"kind": kind, "name": "made", "on": on or [], **fields}


def residual(above: str, below: list[tuple[str, int]], ring: list[str]) -> dict[str, Any]:
    return {"what": "", "numerator": poly(above, ring), "denominator": powers(below, ring)}


def identity(
    number: int,
    quotients: list[str],
    ring: list[str],
    factors: list[tuple[str, int]] | None = None,
    constant: str = "1",
) -> dict[str, Any]:
    return {
        "residual": number,
        "factors": powers(factors or [], ring),
        "constant": constant,
        "quotients": [poly(q, ring) for q in quotients],
    }


def zero(*identities: Any) -> dict[str, Any]:
    return {"case": "zero", "identities": list(identities)}


def proof(ring: list[str], **fields: Any) -> dict[str, Any]:
    return {
        "ring": ring,
        "auxiliary": [],
        "settled": [],
        "exchanged": [],
        "inverted": [],
        "zeros": [],
        "signs": [],
        "equations": [],
        "divisors": [],
        "positive": [],
        **fields,
    }


def divisor(
    formula: str, factors: list[tuple[str, int]], ring: list[str], content: str = "1"
) -> dict[str, Any]:
    return {"formula": formula, "content": content, "factors": powers(factors, ring)}


def equation(text: str, ring: list[str], source: str = "") -> dict[str, Any]:
    return {"poly": poly(text, ring), "from": source or text}


def proven(
    claim: dict[str, Any], *proofs: Any, sample: dict[str, Any], **more: Any
) -> dict[str, Any]:
    return {
        "format": "chaplygin certificate 2",
        "verdict": "proven",
        "claim": claim,
        "proofs": list(proofs),
        "sample": sample,
        **more,
    }


def refuted(claim: dict[str, Any], **witness: Any) -> dict[str, Any]:
    return {
        "format": "chaplygin certificate 2",
        "verdict": "refuted",
        "claim": claim,
        "witness": witness,
    }
