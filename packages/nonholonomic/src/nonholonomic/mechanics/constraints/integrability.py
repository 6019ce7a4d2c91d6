"""Whether constraints on velocities are holonomic (§2.1).

The admissible fields and all their iterated commutators span a space of some dimension (theorem of
Rashevskii and Chow). If it is that of the configuration space, any two configurations can be joined
by an admissible motion and the constraints are completely nonholonomic; if it is the number of
admissible fields, they are holonomic (Frobenius); in between, there are as many holonomic
constraints as dimensions are missing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Literal

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.vectors import Vector, dot

from ..lagrangian.mechanism import TIME, Mechanism
from ..lagrangian.structure_functions import structure, written_frame
from .distribution import Distribution, distribution
from .exact_points import ParameterValue, UnsolvedError
from .frobenius import involutive
from .growth import Filtration, filtration, generic
from .holonomic import ConstraintIntegral, constraint_integrals

Word = Literal["free", "holonomic", "in between", "completely nonholonomic"]


@dataclass(frozen=True, repr=False)
class Nonholonomy:
    """The degree of nonholonomy of the constraints of a mechanism.

    Attributes
    ----------
    name : str
    verdict : str
        ``"free"`` without constraints, ``"holonomic"``, ``"in between"`` or ``"completely
        nonholonomic"``.
    proven : bool
        Whether the verdict is certain. Dimensions reached always are; that there are no more is
        certain if as many integrals are known as dimensions are missing, or by the criterion of
        Frobenius.
    dimension : int
        Dimension of the configuration space, on which given position constraints hold.
    rank : int
        Number of admissible velocities.
    growth : tuple of int
        Dimensions spanned by the admissible fields, by these and their commutators, and so on.
    words : tuple of tuple of str
        The commutators that span each step, such as ``[η1, η2]``.
    integrals : tuple of ConstraintIntegral
        F of the holonomic constraints F(q) = const that were found.
    point : mapping of Symbol to formula
        A rational point (rational tangents of half angles) with this growth; empty if the growth
        was found modulo a prime.
    elsewhere : tuple of int
        The growth at almost all other values of the parameters; empty if it is the same.
    depends_on_time : bool
        Whether time is one of the coordinates, as constraints are affine or depend on it.
    almost : bool
        Whether the result holds for almost all values of the parameters, but is not known for the
        present ones, because no point was found for them.
    """

    name: str
    verdict: Word
    proven: bool
    dimension: int
    rank: int
    growth: tuple[int, ...]
    words: tuple[tuple[str, ...], ...]
    integrals: tuple[ConstraintIntegral, ...]
    point: Mapping[sp.Symbol, sp.Expr]
    elsewhere: tuple[int, ...] = ()
    depends_on_time: bool = False
    almost: bool = False

    @property
    def holonomic(self) -> int:
        """The number of independent holonomic constraints."""
        return self.dimension - self.growth[-1]

    @property
    def constraints(self) -> int:
        """The number of independent constraints."""
        return self.dimension - self.rank

    def __repr__(self) -> str:
        return str(self)

    def __str__(self) -> str:
        return " ".join(_sentences(self))


@arguments_checked
def nonholonomy(mechanism: Mechanism | Distribution) -> Nonholonomy:
    """Decide whether constraints are holonomic, and find their integrals.

    Parameters
    ----------
    mechanism : Mechanism or Distribution
        Its constraints must be linear in the velocities; affine and time-dependent ones are treated
        in the space of time and configuration.

    Returns
    -------
    Nonholonomy

    Raises
    ------
    InputError
        If a constraint is not linear, constraints contradict each other, the frame does not
        span, or no point is found.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, z, xdot, ydot, zdot = sp.symbols("x y z xdot ydot zdot", real=True)
    >>> lagrangian, constraint = (xdot**2 + ydot**2 + zdot**2) / 2, zdot - y * xdot
    >>> particle = nonholonomic.Mechanism(
    ...     "particle", nonholonomic.coordinates(x, y, z), lagrangian, (constraint,)
    ... )
    >>> nonholonomic.nonholonomy(particle).verdict, nonholonomic.nonholonomy(particle).growth
    ('completely nonholonomic', (2, 3))
    """
    admissible = _spanning_distribution(mechanism)
    symbols = [s for s, _ in admissible.constants]
    almost = False
    try:
        here = generic(admissible)
    except UnsolvedError:
        # a relation that cannot be solved for a coordinate may be solvable for a parameter
        here, almost = generic(admissible, symbols), True
    _check_time(admissible, here, symbols if almost else ())
    everywhere = generic(admissible, symbols) if symbols and not almost else here
    special = everywhere.growth != here.growth
    missing = here.dimension - here.final
    integrals = () if special else constraint_integrals(admissible, missing, symbols)
    if len(integrals) < missing and symbols and not almost:
        integrals = max(integrals, constraint_integrals(admissible.with_numbers, missing), key=len)
    certain = missing == 0 or (len(integrals) == missing and all(f.proven for f in integrals))
    if not certain and not almost and _word(here) == "holonomic":
        certain = involutive(admissible.with_numbers)
    return Nonholonomy(
        admissible.name,
        _word(here),
        certain,
        here.dimension,
        here.rank,
        here.growth,
        here.words,
        integrals,
        here.point,
        everywhere.growth if special else (),
        TIME in admissible.coordinates,
        almost,
    )


def _spanning_distribution(mechanism: Mechanism | Distribution) -> Distribution:
    """The distribution of admissible velocities; InputError unless the frame spans."""
    if isinstance(mechanism, Distribution):
        return mechanism
    structure(written_frame(mechanism), mechanism.name)
    return distribution(mechanism)


def _check_time(admissible: Distribution, here: Filtration, free: Sequence[sp.Symbol]) -> None:
    """Refuse affine constraints that no velocity satisfies."""
    if TIME not in admissible.coordinates:
        return
    # with the form dt = 0 added the rank must fall; otherwise all admissible velocities have ṫ = 0
    still = tuple(sp.S.One if field.get(TIME) == 1 else sp.S.Zero for field in admissible.frame)
    if generic(replace(admissible, forms=(*admissible.forms, still)), free).rank == here.rank:
        raise InputError(
            f"{admissible.name}: the constraints contradict each other; no velocity satisfies all "
            "of them at a generic configuration"
        )


@arguments_checked
def nonholonomy_at(
    mechanism: Mechanism | Distribution, point: Mapping[sp.Symbol, ParameterValue]
) -> Filtration:
    """The growth at a point, which may be singular; see :func:`~.growth.filtration`.

    Parameters
    ----------
    mechanism : Mechanism or Distribution
    point : mapping of Symbol to number
        Values of coordinates and parameters.

    Returns
    -------
    Filtration
        The dimensions spanned by iterated brackets, step by step.

    Raises
    ------
    InputError
        If the point is not in the configuration space, or a value is missing.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, z = sp.symbols("x y z", real=True)
    >>> frame = nonholonomic.coordinates(x, y, z)
    >>> _, v, w = frame.velocities
    >>> skate = nonholonomic.Mechanism("skate", frame, sp.S.Zero, (w - x * v,))
    >>> nonholonomic.mechanics.constraints.nonholonomy_at(skate, {x: 1, y: 0, z: 0}).growth
    (2, 3)
    """
    admissible = _spanning_distribution(mechanism)
    return filtration(admissible, point)


def _word(growth: Filtration) -> Word:
    if growth.rank == growth.dimension:
        return "free"
    if growth.final == growth.dimension:
        return "completely nonholonomic"
    return "holonomic" if growth.final == growth.rank else "in between"


def _sentences(verdict: Nonholonomy) -> list[str]:
    where = "space of time and configuration" if verdict.depends_on_time else "configuration space"
    known = "time and configuration" if verdict.depends_on_time else "the configuration"
    if verdict.verdict == "free":
        return [
            "There are no constraints on the velocities besides those that keep the "
            f"{verdict.dimension}-dimensional configuration space."
        ]
    sentences = [
        f"{_count_text(verdict.constraints, 'constraint')} on {verdict.dimension} velocities "
        f"{'leaves' if verdict.constraints == 1 else 'leave'} {verdict.rank}; with their "
        f"commutators the admissible fields span {_list_text(verdict.growth)} "
        f"dimensions of the {where}."
    ]
    if verdict.verdict == "completely nonholonomic":
        sentences.append(
            f"The constraints are completely nonholonomic: no function of {known} is constant "
            "along all admissible motions."
        )
    elif verdict.verdict == "holonomic":
        sentences.append(
            f"The constraints are holonomic: they confine the configuration to surfaces of "
            f"dimension {verdict.rank}."
        )
    else:
        sentences.append(
            f"The constraints are nonholonomic, but {verdict.holonomic} of them "
            f"{'is' if verdict.holonomic == 1 else 'are'} holonomic in effect."
        )
    if verdict.almost:
        sentences.append("(For almost all values of the parameters; these were not tried.)")
    return [*sentences, *_integrals(verdict), *_elsewhere(verdict)]


def _integrals(verdict: Nonholonomy) -> list[str]:
    if not verdict.holonomic:
        return []
    sentences = []
    if verdict.integrals:
        formulas = ", ".join(f"{_text(f.formula)} = const" for f in verdict.integrals)
        sentences.append(f"Constant along every admissible motion: {formulas}.")
    lacking = verdict.holonomic - len(verdict.integrals)
    if lacking:
        sentences.append(
            f"{_count_text(lacking, 'further function' if verdict.integrals else 'function')} of "
            f"this kind {'exists' if lacking == 1 else 'exist'} locally; no formula was found."
        )
    if not verdict.proven:
        sentences.append(
            "(That the dimension is not greater was computed at random points, not proven.)"
        )
    return sentences


def _elsewhere(verdict: Nonholonomy) -> list[str]:
    if not verdict.elsewhere:
        return []
    return [
        "This holds for the present values of the parameters only: for almost all others the "
        f"dimensions are {_list_text(verdict.elsewhere)}."
    ]


def _count_text(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _list_text(numbers: Sequence[int]) -> str:
    return ", ".join(map(str, numbers))


def _text(formula: sp.Expr) -> str:
    from flowlanes.printing.formula import text

    return text(_with_scalar_products(formula))


def _with_scalar_products(formula: sp.Expr) -> sp.Expr:
    """A formula with sums of products of components written as scalar products."""
    names = {str(s)[:-2] for s in formula.free_symbols if str(s)[-2:] in ("_1", "_2", "_3")}
    expanded = sp.expand(formula)
    factors = [sp.S.One, *sorted(formula.free_symbols, key=str)]
    for left, right in combinations([Vector(name) for name in sorted(names)], 2):
        product = sp.Add(*(a * b for a, b in zip(left, right, strict=True)))
        for factor in factors:
            number = expanded.coeff(factor * left.symbols[0] * right.symbols[0])
            remainder = sp.expand(expanded - number * factor * product)
            if number.is_Number and _terms(remainder) == _terms(expanded) - 3:
                expanded = remainder + number * factor * dot(left, right)
    return expanded


def _terms(formula: sp.Expr) -> int:
    return len([term for term in sp.Add.make_args(formula) if term != 0])
