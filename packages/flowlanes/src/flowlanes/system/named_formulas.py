"""Named formulas: pairs of a quantity and a formula."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import sympy as sp

from ..errors import InputError
from ..formula_words import RESERVED_WORDS
from .vectors import Diagonal, Symmetric, Vector, to_components

#: Named quantities (symbols, vectors, tensors), each with a formula.
Pairs: TypeAlias = tuple[tuple[sp.Basic, sp.Basic], ...]

Quantity: TypeAlias = Vector | Diagonal | Symmetric | sp.Symbol


def as_pairs(formulas: Mapping[sp.Basic, sp.Basic] | Iterable[tuple[sp.Basic, sp.Basic]]) -> Pairs:
    """Named formulas as pairs."""
    return tuple(formulas.items()) if isinstance(formulas, Mapping) else tuple(formulas)


def require_names(owner: str, names: Iterable[object]) -> None:
    """Check that the names of quantities are identifiers, not reserved, and distinct.

    Raises
    ------
    InputError
        If a name is not; the message says why.
    """
    for name, count in Counter(map(str, names)).items():
        if not name.isidentifier():
            raise InputError(
                f"{owner}: {name!r} is no name for a state variable, a definition or a "
                "parameter; a name is a letter followed by letters, digits and underscores"
            )
        if name in RESERVED_WORDS:
            raise InputError(
                f"{owner}: {name} is a number or a function in every formula, and no name for a "
                "state variable, a definition or a parameter; choose another"
            )
        if count > 1:
            raise InputError(
                f"{owner}: {name} stands for two things; each state variable, definition "
                "and parameter needs a name of its own"
            )


def by_name(formula: sp.Basic | float, symbols: Iterable[sp.Symbol]) -> sp.Expr:
    """The formula with symbols replaced by known ones of the same name.

    ``Symbol("x")`` and ``Symbol("x", real=True)`` differ for SymPy, but mean the same
    in a formula that a user writes.
    """
    named = {symbol.name: symbol for symbol in symbols}
    written = sp.sympify(formula)
    return written.xreplace({s: named[s.name] for s in written.free_symbols if s.name in named})


def with_formulas(value: object) -> object:
    """A value with mappings as pairs, lists as tuples and numbers as SymPy numbers.

    Examples
    --------
    >>> with_formulas({sp.Symbol("x"): 2})
    ((x, 2),)
    """
    if isinstance(value, Mapping):
        value = tuple(value.items())
    if isinstance(value, tuple | list):
        return tuple(with_formulas(item) for item in value)
    if isinstance(value, int | float) and not isinstance(value, bool):
        return sp.sympify(value)
    return value


def expand(
    formula: sp.Expr, definitions: Mapping[sp.Symbol, sp.Expr] | Iterable[tuple[sp.Symbol, sp.Expr]]
) -> sp.Expr:
    """The formula with all definitions expanded, which may depend on each other.

    Examples
    --------
    >>> x, y, z = sp.symbols("x y z")
    >>> expand(z + 1, {y: x**2, z: 3 * y})
    3*x**2 + 1
    """
    values = dict(definitions)
    while formula.free_symbols & values.keys():
        formula = formula.xreplace(values)
    return formula


def definition_values(
    steps: Iterable[tuple[sp.Symbol, sp.Expr]], values: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr]:
    """Values by symbol, extended by the steps in order with earlier values substituted."""
    formulas = dict(values)
    for symbol, value in steps:
        formulas[symbol] = value.xreplace(formulas)
    return formulas


def needed_steps(
    steps: Sequence[tuple[sp.Symbol, sp.Expr]],
    formulas: Iterable[sp.Expr],
    inputs: Iterable[sp.Symbol] = (),
) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """The steps on which formulas depend, in order; the symbols `inputs` are known."""
    known = set(inputs)
    wanted = {s for formula in formulas for s in formula.free_symbols} - known
    chosen = []
    for symbol, value in reversed(steps):
        if symbol in wanted:
            chosen.append((symbol, value))
            wanted |= value.free_symbols - known
    return tuple(reversed(chosen))


def by_dependence(definitions: Pairs, symbols: Iterable[sp.Symbol]) -> tuple[Pairs, Pairs]:
    """Definitions that do not depend on any of the symbols, and the others."""
    moving = set(symbols)
    before: Pairs = ()
    after: Pairs = ()
    for pair in definitions:
        if to_components(pair[1]).free_symbols & moving:
            moving.update(scalar_names((pair,)))
            after += (pair,)
        else:
            before += (pair,)
    return before, after


def flat(names: Iterable[Quantity]) -> tuple[sp.Symbol, ...]:
    """Named quantities as scalars, in order."""
    return tuple(s for n in names for s in ((n,) if isinstance(n, sp.Symbol) else n.symbols))


def flat_pairs(pairs: Pairs) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """Pairs (named quantity, formula) as pairs (scalar symbol, scalar formula)."""
    scalars: list[tuple[sp.Symbol, sp.Expr]] = []
    for name, formula in pairs:
        value = to_components(sp.sympify(formula))
        if isinstance(name, sp.Symbol):
            scalars.append((name, value))
        elif isinstance(name, Vector):
            scalars.extend(zip(name.symbols, value, strict=True))
        else:
            scalars.extend(zip(name.symbols, name.independent(value), strict=True))
    return tuple(scalars)


def scalars(value: object) -> list[sp.Expr]:
    """The scalar formulas in a scalar, vector, matrix or sequence of these, in order.

    Examples
    --------
    >>> scalars((sp.Symbol("k"), Vector("M")))
    [k, M_1, M_2, M_3]
    """
    if isinstance(value, tuple | list):
        return [scalar for part in value for scalar in scalars(part)]
    components = to_components(sp.sympify(value))
    return list(components) if isinstance(components, sp.MatrixBase) else [components]


def in_components(value: Any) -> Any:
    """A value with its formulas in components; named vectors give one pair for each component.

    Examples
    --------
    >>> M = Vector("M")
    >>> in_components(((M, 2 * M),))
    ((M_1, 2*M_1), (M_2, 2*M_2), (M_3, 2*M_3))
    """
    if isinstance(value, sp.Basic | sp.MatrixBase):
        return to_components(value)
    if not isinstance(value, tuple):
        return value
    if any(isinstance(p, tuple) and p and isinstance(p[0], sp.MatrixExpr) for p in value):
        return flat_pairs(value)
    return tuple(map(in_components, value))


def scalar_names(pairs: Pairs) -> list[sp.Symbol]:
    """The names of pairs (named quantity, formula), one for each scalar component."""
    names = ((name,) if isinstance(name, sp.Symbol) else name.symbols for name, _ in pairs)
    return [symbol for symbols in names for symbol in symbols]


def in_words(names: Iterable[sp.Basic]) -> str:
    """Named quantities with their numbers of components, such as "M (3 numbers), theta"."""
    counts = ((name, len(getattr(name, "symbols", ()))) for name in names)
    return ", ".join(
        f"{name} ({count} numbers)" if count > 1 else str(name) for name, count in counts
    )


def repeated_name(names: Sequence[sp.Symbol]) -> sp.Symbol | None:
    """A name that occurs more than once, or None."""
    return next((name for i, name in enumerate(names) if name in names[:i]), None)
