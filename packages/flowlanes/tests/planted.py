"""Wrong laws, made from right ones by one slip: a sign, an exponent, an index, a stray term."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

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
from flowlanes.system.system import System
from flowlanes.system.vectors import to_components

Slip = Callable[[sp.Expr, System], sp.Expr | None]


def wrong_sign(formula: sp.Expr, system: System) -> sp.Expr | None:
    """A term that moves, in a sum with others, with the other sign."""
    moving = moving_symbols(system)
    for part in sp.preorder_traversal(formula):
        if part.is_Add:
            terms = [term for term in part.args if term.free_symbols & moving]
            if terms and len(part.args) > 1:
                return formula.xreplace({part: part - 2 * terms[-1]})
    return None


def wrong_exponent(formula: sp.Expr, system: System) -> sp.Expr | None:
    """The cube of a quantity that moves in the place of the quantity, in one term of more."""
    if formula.is_Symbol:
        return None
    return _in_one_term(formula, system, lambda symbol: symbol**3)


def wrong_index(formula: sp.Expr, system: System) -> sp.Expr | None:
    """A component in the place of its neighbour, in one term."""
    names = {str(s): s for s in moving_symbols(system)}

    def neighbour(symbol: sp.Symbol) -> sp.Symbol | None:
        stem, _, index = str(symbol).rpartition("_")
        return names.get(f"{stem}_{ {'1': '2', '2': '3', '3': '1'}.get(index) }")

    return _in_one_term(formula, system, neighbour)


def moving_symbols(system: System) -> set[sp.Symbol]:
    """The state, and the definitions that depend on it."""
    moving = set(system.symbols)
    for symbol, value in system.scalar_definitions:
        if value.free_symbols & moving:
            moving.add(symbol)
    return moving


def _in_one_term(
    formula: sp.Expr, system: System, change: Callable[[sp.Symbol], sp.Expr | None]
) -> sp.Expr | None:
    """A change of one moving symbol, in the first product or power that holds it."""
    moving = moving_symbols(system)
    for part in sp.preorder_traversal(formula):
        if not (part.is_Mul or part.is_Pow or part.is_Symbol):
            continue
        for symbol in sorted(part.free_symbols & moving, key=str):
            changed = change(symbol)
            if changed is not None:
                return formula.xreplace({part: part.xreplace({symbol: changed})})
    return None


def stray_term(formula: sp.Expr, system: System) -> sp.Expr | None:
    """A variable of the state added."""
    return formula + _driven(system)[0]


def _driven(system: System) -> list[sp.Symbol]:
    """The variables of the state whose rate is not zero."""
    speeds = zip(system.symbols, system.rates, strict=True)
    return [symbol for symbol, rate in speeds if rate != 0]


def wrong_factor(formula: sp.Expr, system: System) -> sp.Expr | None:
    """Twice the formula."""
    return 2 * formula


def wrong_density(exponent: sp.Expr, system: System) -> sp.Expr | None:
    """Another exponent of the density."""
    return exponent + 1


SLIPS: dict[str, Slip] = {
    "sign": wrong_sign,
    "exponent": wrong_exponent,
    "index": wrong_index,
    "stray": stray_term,
}


@dataclass(frozen=True)
class Part:
    """Formulas of a law, the slips they may suffer, and the law with other formulas instead."""

    name: str
    formulas: list[sp.Expr]
    put: Callable[[Sequence[sp.Expr]], Law]
    slips: dict[str, Slip]

    def wrong(self, system: System) -> Iterator[tuple[str, Law]]:
        """The law with each slip in the first formula that admits it."""
        steps = dict(system.scalar_definitions)
        for name, slip in self.slips.items():
            for i, formula in enumerate(self.formulas):
                changed = slip(_defined(formula, steps), system)
                if changed is not None and changed != formula:
                    formulas = [*self.formulas[:i], changed, *self.formulas[i + 1 :]]
                    yield f"{self.name} {name}", self.put(formulas)
                    break


def _defined(formula: sp.Expr, steps: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """What a formula that is a mere name stands for."""
    while formula in steps:
        formula = steps[formula]
    return formula


def wrong_laws(law: Law, system: System) -> Iterator[tuple[str, Law]]:
    """The law with each slip that its formulas admit, as_printed left out."""
    for part in parts(replace(law, as_printed=None), system):
        yield from part.wrong(system)


def parts(law: Any, system: System) -> Iterator[Part]:
    """What a law is made of."""
    match law:
        case Integral() | Identity():
            yield _own("value", law)
        case Measure():
            yield from _of_a_measure(law, system)
        case Symmetry():
            yield _of_pairs("field", law)
        case PoissonStructure():
            yield from _of_a_bracket(law)
        case ConformallyHamiltonian():
            yield _own("hamiltonian", law)
            yield _own("multiplier", law, {**SLIPS, "factor": wrong_factor})
            for part in _of_a_bracket(law.structure):
                yield replace(part, put=lambda f, p=part: replace(law, structure=p.put(f)))
        case Isomorphism():
            yield _of_pairs("map", law)
            yield _own("time", law, {**SLIPS, "factor": wrong_factor})
        case Reduction():
            yield _own("equations", law)
            yield _of_pairs("quantities", law)
        case _:
            raise TypeError(type(law).__name__)


def _own(field: str, law: Any, slips: dict[str, Slip] = SLIPS) -> Part:
    """An attribute that is a formula, or several."""
    value = getattr(law, field)
    formulas = _scalars(value)

    def put(changed: Sequence[sp.Expr]) -> Law:
        many = isinstance(value, tuple | list) or len(changed) > 1
        made: Law = replace(law, **{field: tuple(changed) if many else changed[0]})
        return made

    return Part(field, formulas, put, slips)


def _of_pairs(field: str, law: Any) -> Part:
    """An attribute that maps names to formulas, each scalar component on its own."""
    pairs = [
        (name, formula)
        for vector, value in getattr(law, field)
        for name, formula in zip(_names(vector), _scalars(value), strict=True)
    ]
    names = [name for name, _ in pairs]

    def put(changed: Sequence[sp.Expr]) -> Law:
        made: Law = replace(law, **{field: tuple(zip(names, changed, strict=True))})
        return made

    return Part(field, [formula for _, formula in pairs], put, SLIPS)


def _of_a_measure(law: Measure, system: System) -> Iterator[Part]:
    """The bases of its density that move, and their exponents."""
    moving = moving_symbols(system)
    pairs = [
        (to_components(sp.sympify(base)), sp.sympify(exponent)) for base, exponent in law.density
    ]
    moved = [(b, e) for b, e in pairs if b.free_symbols & moving]
    if not moved:
        pairs = moved = [(sp.Add(*_driven(system)), sp.S.Zero)]
    rest = tuple(pair for pair in pairs if pair not in moved)
    bases, exponents = (list(part) for part in zip(*moved, strict=True))

    def with_bases(changed: Sequence[sp.Expr]) -> Law:
        return replace(law, density=(*rest, *zip(changed, exponents, strict=True)))

    def with_exponents(changed: Sequence[sp.Expr]) -> Law:
        return replace(law, density=(*rest, *zip(bases, changed, strict=True)))

    if any(exponents):
        yield Part("density", bases, with_bases, SLIPS)
    yield Part("density", exponents, with_exponents, {"power": wrong_density})


def _of_a_bracket(law: PoissonStructure) -> Iterator[Part]:
    """Entries with their mirror images, so that the bracket stays skew; Casimirs; the rank."""
    size = law.matrix.shape[0]
    places = [(i, j) for i in range(size) for j in range(i + 1, size) if law.matrix[i, j] != 0]

    def put(changed: Sequence[sp.Expr]) -> Law:
        matrix = law.matrix.as_mutable()
        for (i, j), entry in zip(places, changed, strict=True):
            matrix[i, j], matrix[j, i] = entry, -entry
        return replace(law, matrix=matrix)

    slips = {name: slip for name, slip in SLIPS.items() if slip is not stray_term}
    yield Part("bracket", [law.matrix[place] for place in places], put, slips)
    if law.casimirs:
        yield _own("casimirs", law)
    if law.rank is not None:
        yield Part(
            "rank",
            [sp.Integer(law.rank)],
            lambda changed: replace(law, rank=int(changed[0])),
            {"two less": lambda number, _: number - 2},
        )


def _names(name: Any) -> tuple[sp.Symbol, ...]:
    return (name,) if isinstance(name, sp.Symbol) else name.symbols


def _scalars(value: Any) -> list[sp.Expr]:
    if isinstance(value, tuple | list):
        return [s for part in value for s in _scalars(part)]
    made = to_components(sp.sympify(value))
    return list(made) if isinstance(made, sp.MatrixBase) else [made]
