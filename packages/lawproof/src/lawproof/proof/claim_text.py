"""Systems, laws and polynomials as text in the format of a certificate."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TypeAlias

import sympy as sp

from flowlanes.memory import memory
from flowlanes.system.formula_text import short_text
from flowlanes.system.laws import Law
from flowlanes.system.parameters import conjuncts
from flowlanes.system.system import System

from .fields.quotient_ring import Poly
from .level.level_formulas import assumed_relations

#: A mapping of a certificate; a polynomial as a list of its terms.
Text: TypeAlias = dict[str, object]
Terms: TypeAlias = list[list[object]]


def claim_text(system: System, law: Law) -> Text:
    """A law of a system as text, including everything to which it refers."""
    basic = law.basic(system)
    return {"system": _system(system), "law": {"kind": type(basic).__name__, **_law(system, basic)}}


@memory(8)
def _system(system: System) -> Text:
    return {
        "name": system.name,
        "state": [str(s) for s in system.symbols],
        "rates": [short_text(rate) for rate in system.rates],
        "definitions": [[str(s), short_text(value)] for s, value in system.scalar_definitions],
        "parameters": [str(p.symbol) for p in system.parameters],
        "relations": _text(system.scalar.relations),
        "guards": [short_text(formula) for formula in guards(system)],
        "admissible": [short_text(relation) for relation in admissible(system)],
    }


def guards(system: System) -> tuple[sp.Expr, ...]:
    """The formulas that are positive on the domain, apart from conditions on parameters."""
    declared = [guard.value for guard in system.scalar.guards if not guard.lift_off]
    assumed = [s for s in system.symbols if s.is_positive]
    assumed += [-s for s in system.symbols if s.is_negative]
    return (*declared, *assumed)


def admissible(system: System) -> tuple[sp.Basic, ...]:
    """The conditions on the parameters, with conjunctions split and disjunctions kept."""
    relations: list[sp.Basic] = []
    for parameter in system.parameters:
        for condition in parameter.admissible:
            relations += conjuncts(condition)
        assumed = [r for r in assumed_relations(parameter.symbol) if r not in (sp.true, sp.false)]
        # The strongest assumption implies the others.
        relations += assumed[:1]
    return tuple(r for r in dict.fromkeys(relations) if r not in (sp.true, True))


def _law(system: System, law: Law) -> Text:
    content = {name: _text(value) for name, value in law.claim(system).items()}
    return {"name": law.name, "on": _text(law.scalar.level), **content}


def _text(value: object) -> object:
    """A value of a claim as text: formulas, matrices, systems and nested tuples."""
    match value:
        case System():
            return _system(value)
        case sp.MatrixBase():
            return [[short_text(entry) for entry in row] for row in value.tolist()]
        case sp.Basic():
            return short_text(value)
        case tuple():
            return [_text(part) for part in value]
        case Mapping():
            return {name: _text(part) for name, part in value.items()}
        case _:
            return value


def terms_text(poly: Poly, places: Sequence[int | None]) -> Terms:
    """A polynomial as a list of terms; `places` gives the index of each generator in the ring."""
    return [
        [str(number), [x for i, n in enumerate(exponents) if n for x in (places[i], int(n))]]
        for exponents, number in poly.to_dict().items()
    ]


def powers_text(powers: Iterable[tuple[Poly, int]], places: Sequence[int | None]) -> Terms:
    """A product of powers of polynomials as text."""
    return [[terms_text(poly, places), power] for poly, power in powers]
