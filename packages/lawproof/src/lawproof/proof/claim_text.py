"""Systems, laws and polynomials as the text of a certificate."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeAlias

import sympy as sp

from flowlanes.memory import memory
from flowlanes.system.formula_text import short_text
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Reduction,
    Symmetry,
)
from flowlanes.system.named_formulas import expand
from flowlanes.system.parameters import conjuncts
from flowlanes.system.system import System, flat
from flowlanes.system.vectors import Vector, to_components

from .fields.quotient_ring import Poly
from .level.level_formulas import assumed_relations
from .level.named_formulas import scalars

#: A mapping of a certificate, and a polynomial as a list of its terms.
Text: TypeAlias = dict[str, object]
Terms: TypeAlias = list[list[object]]


def claim_text(system: System, law: Law) -> Text:
    """A law of a system as text, with everything that it refers to written out."""
    return {"system": _system(system), "law": {"kind": type(law).__name__, **_law(system, law)}}


@memory(8)
def _system(system: System) -> Text:
    return {
        "name": system.name,
        "state": [str(s) for s in system.symbols],
        "rates": [short_text(rate) for rate in system.rates],
        "definitions": [[str(s), short_text(value)] for s, value in system.scalar_definitions],
        "parameters": [str(p.symbol) for p in system.parameters],
        "relations": _formulas(system.relations),
        "guards": [short_text(formula) for formula in guards(system)],
        "admissible": [short_text(relation) for relation in admissible(system)],
    }


def guards(system: System) -> tuple[sp.Expr, ...]:
    """The formulas that are positive in the domain, apart from those of parameters."""
    declared = [to_components(guard.value) for guard in system.guards if not guard.lift_off]
    assumed = [s for s in system.symbols if s.is_positive]
    assumed += [-s for s in system.symbols if s.is_negative]
    return (*declared, *assumed)


def admissible(system: System) -> tuple[sp.Basic, ...]:
    """The relations that parameters obey, none of which is a conjunction, and alternatives."""
    relations: list[sp.Basic] = []
    for parameter in system.parameters:
        for condition in parameter.admissible:
            relations += conjuncts(condition)
        assumed = [r for r in assumed_relations(parameter.symbol) if r not in (sp.true, sp.false)]
        # the strongest says it all
        relations += assumed[:1]
    return tuple(r for r in dict.fromkeys(relations) if r not in (sp.true, True))


def _law(system: System, law: Law) -> Text:
    return {"name": law.name, "on": _formulas(law.on), **_content(system, law)}


def _content(system: System, law: Law) -> Text:
    if isinstance(law, Integral):
        return {"value": short_text(to_components(law.value))}
    if isinstance(law, Measure):
        density = [
            [short_text(to_components(base)), short_text(sp.sympify(power))]
            for base, power in law.density
        ]
        return {"density": density}
    if isinstance(law, Symmetry):
        return {"field": _pairs(law.field)}
    if isinstance(law, PoissonStructure):
        return _bracket(law)
    if isinstance(law, ConformallyHamiltonian):
        return {
            "multiplier": short_text(to_components(law.multiplier)),
            "hamiltonian": short_text(to_components(law.hamiltonian)),
            "structure": {"name": law.structure.name, **_bracket(law.structure)},
        }
    if isinstance(law, Isomorphism):
        return {
            "target": _system(law.target),
            "map": _pairs(law.map),
            "time": short_text(to_components(law.time)),
            "constants": _pairs(law.constants),
            "onto": [short_text(_there(system, law, condition)) for condition in law.onto],
        }
    if isinstance(law, Reduction):
        quantities = _pairs(law.quantities)
        return {"quantities": quantities, "equations": _formulas(law.equations)}
    assert isinstance(law, Identity)
    return {
        "quantities": _pairs(law.quantities),
        "value": [short_text(f) for f in scalars(law.value)],
    }


def _there(system: System, law: Isomorphism, condition: sp.Expr) -> sp.Expr:
    """A condition on the image, without definitions of the source that the target has not."""
    target = law.target
    theirs = {*target.symbols, *target.defaults, *(s for s, _ in target.scalar_definitions)}
    steps = {s: value for s, value in system.scalar_definitions if s not in theirs}
    return expand(to_components(condition), steps)


def _bracket(law: PoissonStructure) -> Text:
    size = law.matrix.shape[0]
    return {
        "matrix": [[short_text(law.matrix[i, j]) for j in range(size)] for i in range(size)],
        "casimirs": _formulas(law.casimirs),
        "rank": None if law.rank is None else int(law.rank),
    }


def _formulas(formulas: Iterable[sp.Expr]) -> list[str]:
    return [short_text(to_components(formula)) for formula in formulas]


def _pairs(pairs: Iterable[tuple[sp.Symbol | Vector, sp.Expr]]) -> list[list[str]]:
    texts = []
    for name, formula in pairs:
        texts += [
            [str(n), short_text(f)] for n, f in zip(flat([name]), scalars(formula), strict=True)
        ]
    return texts


def terms_text(poly: Poly, places: Sequence[int | None]) -> Terms:
    """A polynomial as a list of terms; `places` says where its generators stand in the ring."""
    return [
        [str(number), [x for i, n in enumerate(exponents) if n for x in (places[i], int(n))]]
        for exponents, number in poly.to_dict().items()
    ]


def powers_text(powers: Iterable[tuple[Poly, int]], places: Sequence[int | None]) -> Terms:
    """A product of powers of polynomials."""
    return [[terms_text(poly, places), power] for poly, power in powers]
