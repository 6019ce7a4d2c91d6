"""Regions, boundaries and corners of a bifurcation diagram."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations

import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpq_poly

from flowlanes.errors import InputError

from .arrangement import Arrangement, Cell, fraction
from .critical_motions import Arc, Circles, circles_at_a_double_root, circles_at_a_pole
from .families import IntegralPlane
from .tori import Family, families


@dataclass(frozen=True)
class Region:
    """A part of the plane over which the motions are of one kind.

    Attributes
    ----------
    number : int
        0 where there are no motions, else counted from 1.
    families : tuple of Family
        The families of tori, one for each pair of ovals.
    cells : frozenset of cells Cells of the arrangement that make up the region.
    sample : two Fractions
        A point of the region.

    Examples
    --------
    >>> import nonholonomic
    >>> nonholonomic.closed_form.bifurcation_diagram("veselova").regions[0].tori
    2
    """

    number: int
    families: tuple[Family, ...]
    cells: frozenset[Cell]
    sample: tuple[Fraction, Fraction]

    @property
    def tori(self) -> int:
        """Number of tori in the phase space on every level of the region."""
        return sum(family.tori for family in self.families)


@dataclass(frozen=True)
class Boundary:
    """A curve of the plane with periodic motions over it.

    Attributes
    ----------
    curve : sympy expression
        The curve is the zero set of this expression in the symbols of the axes.
    words : str
        A description of the motions.
    circles : int
        Number of circles in the phase space, on every level of the boundary.
    stable : bool
        Stable within their levels' neighbours: tori surround them; if not, they have separatrices.
    pole : int
        Body axis i if ν_i vanishes on them, else 0.
    arcs : tuple of cells
        Of the arrangement: pieces of the curve.

    Examples
    --------
    >>> import nonholonomic
    >>> nonholonomic.closed_form.bifurcation_diagram("veselova").boundaries[0].words
    'permanent rotation about axis 1'
    """

    curve: sp.Expr
    words: str
    circles: int
    stable: bool
    pole: int
    arcs: tuple[Cell, ...]


@dataclass(frozen=True)
class Equilibrium:
    """A corner of the diagram over which ν rests at ± a body axis.

    Attributes
    ----------
    place : two Fractions
    axis : int
        1, 2 or 3: the body axis.
    centres : int
        2: a minimum or maximum, stable; 1: a saddle and a centre; 0: a saddle twice.
    """

    place: tuple[Fraction, Fraction]
    axis: int
    centres: int

    @property
    def words(self) -> str:
        """The kind of equilibrium, as text."""
        return ("saddle–saddle", "saddle–centre", "centre–centre")[self.centres]


@dataclass(frozen=True)
class Kinds:
    """The kinds of motion over the cells and arcs of a plane.

    Attributes
    ----------
    poles : three fmpq
        Increasing.
    order : three int
        The body axis of each pole.
    cofactor : fmpq_mpoly
        The curve is y² = ∏(z − e_i) · cofactor.
    bounds : tuple of fmpq_mpoly
        Positive over the motions.
    cells : Arrangement
        Along the discriminant, the values of `cofactor` at the poles and the bounds.
    """

    plane: IntegralPlane
    poles: tuple[fmpq, fmpq, fmpq]
    order: tuple[int, int, int]
    cofactor: fmpq_mpoly
    bounds: tuple[fmpq_mpoly, ...]
    cells: Arrangement

    @cached_property
    def tori(self) -> dict[Cell, tuple[Family, ...]]:
        """The tori over every cell."""
        return {cell: self._tori(*self.cells.sample(cell)) for cell in self.cells.cells}

    def _tori(self, x: fmpq, y: fmpq) -> tuple[Family, ...]:
        if any(_over_point(bound, x, y)(0) < 0 for bound in self.bounds):
            return ()
        return families(self.poles, _over_point(self.cofactor, x, y))

    @cached_property
    def motions(self) -> dict[Cell, frozenset[tuple[str, int, bool, int]]]:
        """The periodic motions over every arc: description, number, stability and axis."""
        return {arc: frozenset(self._motions(arc)) for arc in self.cells.arcs}

    def _motions(self, arc: Cell) -> set[tuple[str, int, bool, int]]:
        column, rank = arc
        beside = (self.tori[column, rank], self.tori[column, rank + 1])
        if not any(beside):
            # Tori surround these circles only on one side of a bound.
            return set()
        curve = self.cells.curves[self.cells.orders[column][rank]]
        for bound, text in zip(self.bounds, self.plane.bounds, strict=True):
            if _divides(curve, bound):
                # Every torus shrinks to one circle.
                count = sum(family.tori for families in beside for family in families)
                return {(text.words, count, True, 0)}
        counts: dict[tuple[str, bool, int], int] = {}
        for circles in self._circles(arc, curve):
            axis = self.order[circles.pole - 1] if circles.pole else 0
            words = (
                self.plane.resting.format(axis)
                if axis
                else f"motion with constant z_{circles.coordinate}"
            )
            key = (words, circles.stable, axis)
            counts[key] = counts.get(key, 0) + circles.count
        return {(words, count, stable, axis) for (words, stable, axis), count in counts.items()}

    def _circles(self, arc: Cell, curve: fmpq_mpoly) -> list[Circles]:
        column, rank = arc
        place = Arc(self.cells.curves, self.cells.samples[column], rank)
        circles: list[Circles] = []
        for number, pole in enumerate(self.poles, 1):
            if _divides(curve, _value_at(self.cofactor, pole)):
                circles += circles_at_a_pole(place, self.poles, self.cofactor, number)
        if _divides(curve, self.cofactor.discriminant("z")):
            circles += circles_at_a_double_root(place, self.poles, self.cofactor)
        return circles

    def regions(self) -> tuple[Region, ...]:
        """Unions of cells between which no motion changes its kind.

        Raises
        ------
        InputError
            If kinds change across a vertical line.
        """
        parent = {cell: cell for cell in self.cells.cells}

        def root(cell: Cell) -> Cell:
            while parent[cell] != cell:
                cell = parent[cell]
            return cell

        open_arcs = [arc for arc, motions in self.motions.items() if not motions]
        for one, other in (*self.cells.joints, *((a, (a[0], a[1] + 1)) for a in open_arcs)):
            if self.tori[one] != self.tori[other]:
                raise InputError(
                    f"{self.plane.name}: the motions change across a vertical line of the diagram; "
                    "exchange the two integrals"
                )
            parent[root(one)] = root(other)
        classes: dict[Cell, list[Cell]] = {}
        for cell in self.cells.cells:
            classes.setdefault(root(cell), []).append(cell)
        components = sorted(classes.values(), key=lambda cells: (not self.tori[cells[0]], cells[0]))
        regions = []
        for number, cells in enumerate(components, 1):
            kind = self.tori[cells[0]]
            x, y = map(fraction, self.cells.sample(cells[0]))
            regions.append(Region(number if kind else 0, kind, frozenset(cells), (x, y)))
        return tuple(regions)

    def boundaries(self) -> tuple[Boundary, ...]:
        """Unions of arcs on one curve with the same motions."""
        arcs_by_kind: dict[tuple[int, tuple[str, int, bool, int]], list[Cell]] = {}
        for (column, rank), motions in self.motions.items():
            for kind in motions:
                arcs_by_kind.setdefault((self.cells.orders[column][rank], kind), []).append(
                    (column, rank)
                )
        return tuple(
            Boundary(self._curve_formula(curve), *kind, tuple(arcs))
            for (curve, kind), arcs in sorted(arcs_by_kind.items())
        )

    def _curve_formula(self, number: int) -> sp.Expr:
        """A curve of the arrangement in the symbols of the axes."""
        x, y = (axis.symbol for axis in self.plane.axes)
        terms = self.cells.curves[number].to_dict().items()
        return sp.Add(*(sp.Rational(str(c)) * x**i * y**j for (i, j, _), c in terms))

    def equilibria(self) -> tuple[Equilibrium, ...]:
        """Levels on which the curve has double roots at two poles, both along straight lines."""
        return tuple(
            equilibrium
            for pair in combinations(range(3), 2)
            if (equilibrium := self._equilibrium(*pair)) is not None
        )

    def _equilibrium(self, first: int, second: int) -> Equilibrium | None:
        poles = self.poles
        place = _crossing(*(_value_at(self.cofactor, poles[n]) for n in (first, second)))
        if place is None:
            return None
        left = _over_point(self.cofactor, *place)
        for n in (first, second):
            left //= fmpq_poly([-poles[n], 1])
        third = 3 - first - second
        signs = [(poles[n] - poles[third]) * left(poles[n]) for n in (first, second)]
        if any(sign == 0 for sign in signs):
            return None
        x, y = map(fraction, place)
        return Equilibrium((x, y), self.order[third], sum(bool(sign < 0) for sign in signs))


def _value_at(polynomial: fmpq_mpoly, z: fmpq) -> fmpq_mpoly:
    """The value of a polynomial at z."""
    value: fmpq_mpoly = polynomial.subs({"z": z})
    return value


def _over_point(polynomial: fmpq_mpoly, x: fmpq, y: fmpq) -> fmpq_poly:
    """A polynomial over a point of the plane, in z."""
    restriction = fmpq_poly()
    for (i, j, power), value in polynomial.to_dict().items():
        restriction[power] = restriction[power] + value * x**i * y**j
    return restriction


def _divides(factor: fmpq_mpoly, polynomial: fmpq_mpoly) -> bool:
    """Whether an irreducible polynomial divides another one."""
    return bool(factor.gcd(polynomial).total_degree() == factor.total_degree())


def _crossing(one: fmpq_mpoly, other: fmpq_mpoly) -> tuple[fmpq, fmpq] | None:
    """The intersection of two straight lines; None if they are parallel or curved."""
    if one.total_degree() != 1 or other.total_degree() != 1:
        return None
    (a, b, c), (d, e, f) = (
        [line.to_dict().get(powers, fmpq(0)) for powers in ((1, 0, 0), (0, 1, 0), (0, 0, 0))]
        for line in (one, other)
    )
    determinant = a * e - b * d
    if determinant == 0:
        return None
    return (b * f - c * e) / determinant, (c * d - a * f) / determinant
