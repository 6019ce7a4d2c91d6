"""The order of terms and factors, with their signs and fractions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, total_ordering

import sympy as sp
from sympy.matrices.expressions import Identity, MatAdd, MatMul, MatrixExpr

from ..system.formula_text import short_text
from ..system.vector_operators import Gradient
from ..system.vectors import Diagonal, Dot, Symmetric, Vector
from .symbol_names import GREEK, letter_of

#: Mass and gravity come first in a product: m g R.
_FIRST = {"m": 0, "g": 1}


def _weight(formula: sp.Basic) -> int:
    """The visual length of a term, by which terms are ordered."""
    match formula:
        case sp.Number() | sp.NumberSymbol() | Diagonal() | Symmetric() | Identity():
            return 0
        case sp.Symbol() | Vector():
            return 1
        case Gradient():
            return 2
        case sp.Pow() if formula.exp.is_Integer:
            # A division counts as one additional factor.
            power = int(formula.exp)
            return abs(power) * _weight(formula.base) + (power < 0)
        case sp.MatrixBase():
            return 1 + sum(map(_weight, formula))
    return sum(map(_weight, formula.args))


@total_ordering
class _Spelling:
    """The text of a formula, computed only if an order depends on it."""

    def __init__(self, formula: sp.Basic) -> None:
        self.formula = formula

    @cached_property
    def text(self) -> str:
        return short_text(self.formula)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Spelling) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)

    def __lt__(self, other: _Spelling) -> bool:
        return self.text < other.text


def _term_key(term: sp.Basic) -> tuple[int, int, bool, _Spelling]:
    """Sort key of terms: ½ (M, u) first, then by length, negative numbers last."""
    negative = is_negative(term)
    place = 1
    if isinstance(term, sp.Number) and negative:
        place = 2
    elif isinstance(term, (sp.Mul, Dot)) and isinstance(term.as_coeff_Mul()[1], Dot):
        place = 1 if negative else 0
    return place, _weight(term), negative, _Spelling(term)


def is_negative(term: sp.Basic) -> bool:
    """True if a term is written with a minus sign."""
    if isinstance(term, (sp.Add, MatAdd)):
        return all(map(is_negative, term.args))
    if isinstance(term, sp.Number):
        return bool(term.is_negative)
    if isinstance(term, (sp.Mul, MatMul)):
        return sum(map(is_negative, term.args)) % 2 == 1
    return False


def opposite(tensor: MatrixExpr) -> MatrixExpr:
    """Minus a vector or tensor, sums term by term."""
    if isinstance(tensor, MatAdd):
        return MatAdd(*(-1 * term for term in tensor.args))
    return -1 * tensor


def as_unit_vector_multiple(formula: sp.Basic) -> sp.Basic:
    """A column with a single nonzero entry c ≠ 1 as c e_i; others unchanged."""
    if isinstance(formula, sp.MatrixBase) and formula.shape[1] == 1:
        present = [i for i, entry in enumerate(formula) if entry != 0]
        if len(present) == 1 and formula[present[0]] != 1:
            axis = [int(i == present[0]) for i in range(formula.shape[0])]
            return MatMul(formula[present[0]], sp.ImmutableDenseMatrix(axis))
    return formula


def sort_terms(terms: Iterable[sp.Basic]) -> list[sp.Basic]:
    """Terms in the order of `_term_key`, a positive one first if there is one."""
    ordered = sorted(terms, key=_term_key)
    head = next((term for term in ordered if not is_negative(term)), ordered[0])
    return [head, *(term for term in ordered if term is not head)]


def common_fraction(formula: sp.Basic) -> sp.Rational:
    """The fraction common to all terms of a sum, written before brackets."""
    if not isinstance(formula, sp.Add):
        return sp.S.One
    shares = {abs(term.as_coeff_Mul()[0]) for term in formula.args}
    share = shares.pop()
    return share if not shares and share.is_Rational and share.q != 1 else sp.S.One


def _factor_key(factor: sp.Expr) -> tuple[int, int, str | _Spelling]:
    """Sort key: letters, derivatives, scalar products, functions, roots, sums."""
    base = factor.base if isinstance(factor, sp.Pow) else factor
    if isinstance(base, sp.Symbol):
        letter = letter_of(str(base))
        kind = 4 if letter.accents or letter.primes else 3 if letter.base in GREEK else 2
        return 0, _FIRST.get(str(base), kind), str(base).casefold()
    rank = 3 if isinstance(base, sp.Add) else 1 if isinstance(base, Dot) else 2
    if base.is_number:
        return 0, 0, str(sp.sstr(factor))
    return rank, 0, _Spelling(factor)


def vector_of(symbols: Sequence[sp.Expr]) -> Vector | None:
    """The vector with these three components, or None."""
    if len(symbols) < 3 or not isinstance(symbols[0], sp.Symbol):
        return None
    vector = Vector(str(symbols[0]).removesuffix("_1"))
    return vector if tuple(symbols) == vector.symbols else None


@dataclass(frozen=True)
class Factors:
    """A product: sign, coefficient p/q, numerator, denominator, tensors."""

    negative: bool
    coefficient: tuple[int, int]
    above: tuple[sp.Expr, ...]
    below: tuple[sp.Expr, ...]
    tensors: tuple[MatrixExpr, ...]


def factors_of(formula: sp.Basic) -> Factors:
    """The factors of a product."""
    if isinstance(formula, MatMul):
        scalar, tensors = formula.as_coeff_matrices()
    else:
        scalar, tensors = formula, ()
    negative = False
    coefficient = sp.S.One
    above: list[sp.Expr] = []
    below: list[sp.Expr] = []
    for signed in sp.Mul.make_args(scalar):
        minus = is_negative(signed)
        negative ^= minus
        factor = -signed if minus else signed
        if isinstance(factor, sp.Rational):
            coefficient = coefficient * factor
        elif isinstance(factor, sp.Pow) and is_negative(factor.exp):
            below.append(sp.Pow(factor.base, -factor.exp))
        else:
            above.append(factor)
    signless = []
    for tensor in tensors:
        minus = is_negative(tensor)
        negative ^= minus
        signless.append(opposite(tensor) if minus else tensor)
    if len(signless) > 1:
        signless = [tensor for tensor in signless if not isinstance(tensor, Identity)] or signless[
            :1
        ]
    return Factors(
        negative,
        (int(coefficient.p), int(coefficient.q)),
        tuple(sorted(above, key=_factor_key)),
        tuple(sorted(below, key=_factor_key)),
        tuple(signless),
    )
