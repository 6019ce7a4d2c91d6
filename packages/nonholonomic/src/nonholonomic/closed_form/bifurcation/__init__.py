"""Bifurcation diagrams: the kinds of motion over the plane of two integrals.

The roots of the curve y² = P(z) over a point determine the motions there (:mod:`.tori`).  They
change only where roots meet, on the discriminant of P.  Its factors are computed exactly, the plane
is cut along them (:mod:`.arrangement`), every cell is examined at a rational point and every arc at
an algebraic one (:mod:`.critical_motions`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp
from flint import fmpq, fmpq_mpoly

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact
from flowlanes.formulas.relative_zero import ROUNDING, SizedNumber, state_sizes, values_with_sizes
from flowlanes.printing.formula import text
from flowlanes.system.named_formulas import by_dependence, definition_values, scalars
from flowlanes.system.overview import Overview, WithOverview

from ...mechanics.rolling.inertia import check_inertia
from ..genus_two.separation import SeparatedSystem
from .arrangement import RING, Arrangement, arrangement, rational
from .families import Axis, IntegralPlane, Z, numbers, plane_named, plane_of
from .regions import Boundary, Equilibrium, Kinds, Region

__all__ = ["Boundary", "Diagram", "Equilibrium", "Region", "bifurcation_diagram", "locate"]


@dataclass(frozen=True, repr=False)
class Diagram(WithOverview):
    """The bifurcation diagram of a system in the plane of two integrals.

    Attributes
    ----------
    plane : IntegralPlane
        The system, the integrals and their curves, in formulas.
    poles : three fmpq
        Increasing.
    order : three int
        The body axis of each pole.
    cofactor : fmpq_mpoly
        The curve is y² = ∏(z − e_i) · cofactor, in x, y (the integrals) and z.
    regions : tuple of Region
        Those with motions first, in the order of their numbers; then those without.
    """

    plane: IntegralPlane
    parameters: Mapping[sp.Symbol, Fraction]
    poles: tuple[fmpq, fmpq, fmpq]
    order: tuple[int, int, int]
    cofactor: fmpq_mpoly
    arrangement: Arrangement
    regions: tuple[Region, ...]
    boundaries: tuple[Boundary, ...]
    equilibria: tuple[Equilibrium, ...]

    def overview(self) -> Overview:
        """The plane, the numbers of tori and the boundaries."""
        axes = " and ".join(str(axis.symbol) for axis in self.axes)
        tori = (f"{r.tori} in region {r.number}" for r in self.regions if r.number)
        stable = (f"{'stable' if b.stable else 'unstable'} {b.words}" for b in self.boundaries)
        return Overview(
            f"Bifurcation diagram of {self.plane.name} in the plane of {axes}",
            (
                ("tori", ", ".join(tori)),
                ("boundaries", "; ".join(dict.fromkeys(stable))),
                ("equilibria", str(len(self.equilibria) or "")),
            ),
        )

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """The two integrals."""
        return self.plane.axes

    def region(self, x: float | Fraction | str, y: float | Fraction | str) -> Region | None:
        """The region of a point; None on a boundary.

        Parameters
        ----------
        x, y : float, int, str or Fraction
            Values of the two integrals; a double is taken as its exact binary value.
        """
        point = rational(Fraction(x)), rational(Fraction(y))
        cell = self.arrangement.cell(*point)
        if cell is None:
            # Some pieces of the curves are not boundaries.
            cell = self.arrangement.arc(*point)
            if any(cell in boundary.arcs for boundary in self.boundaries):
                return None
        return next((region for region in self.regions if cell in region.cells), None)


@arguments_checked
def locate(diagram: Diagram, state: Mapping[sp.Symbol | str, NumberOrText]) -> tuple[float, float]:
    """The point of a diagram that a motion corresponds to.

    Parameters
    ----------
    diagram : Diagram
    state : mapping of Symbol or name to number
        A state of ``diagram.plane.system``, all of its variables.

    Returns
    -------
    (float, float)
        The values of the two integrals.

    Raises
    ------
    InputError
        If a variable is missing, or the state is not on the level that the plane is
        made for.

    Examples
    --------
    >>> import nonholonomic
    >>> diagram = nonholonomic.closed_form.bifurcation_diagram("veselova")
    >>> start = nonholonomic.CATALOGUE["veselova"].start.values
    >>> veselova = nonholonomic.from_catalogue("veselova")
    >>> state = dict(zip(veselova.symbols, nonholonomic.initial_state(veselova, **start)))
    >>> [round(x, 6) for x in nonholonomic.closed_form.locate(diagram, state)]
    [0.724706, 1.844396]
    """
    system, plane = diagram.plane.system, diagram.plane
    values = {str(name): value for name, value in state.items()}
    missing = [str(symbol) for symbol in system.symbols if str(symbol) not in values]
    if missing:
        raise InputError(f"{plane.name}: the state gives no value for {', '.join(missing)}")
    numbers = [exact(values[str(s)]) for s in system.symbols]
    known = state_sizes(system.state, system.symbols, numbers)
    known |= {s: SizedNumber(exact(x), abs(exact(x))) for s, x in diagram.parameters.items()}
    conditions = [*system.relations, *plane.level]
    formulas = scalars((*conditions, *(axis.value for axis in plane.axes)))
    *level, x, y = values_with_sizes(formulas, known, system.required_definitions(formulas))
    for condition, value in zip(conditions, level, strict=True):
        if not value.vanishes(ROUNDING):
            raise InputError(
                f"{plane.name}: {text(condition)} is {float(value.value):.5g} in this state and "
                "must vanish"
            )
    return float(x.value), float(y.value)


@arguments_checked
def bifurcation_diagram(
    subject: str | SeparatedSystem | IntegralPlane,
    parameters: Mapping[sp.Symbol | str, NumberOrText] | None = None,
) -> Diagram:
    """The bifurcation diagram of a separated system, exactly.

    Parameters
    ----------
    subject : str, SeparatedSystem or IntegralPlane
        A name of :data:`.families.PLANES`, or formulas.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the system's defaults, and of constants that the plane holds fixed;
        a float means the shortest decimal that gives it.

    Returns
    -------
    Diagram
        Its regions in the plane of two integrals, with the tori over each, and its curves.

    Raises
    ------
    InputError
        If the name or a parameter is unknown, two moments are equal, no body has these moments,
        or the parameters are not those for which the system separates into genus two.

    Examples
    --------
    >>> import nonholonomic
    >>> diagram = nonholonomic.closed_form.bifurcation_diagram("veselova", {"I_2": 1.7})
    >>> len(diagram.regions) > 0
    True
    """
    if isinstance(subject, str):
        plane = plane_named(subject)
    else:
        plane = plane_of(subject) if isinstance(subject, SeparatedSystem) else subject
    values = numbers(plane, parameters or {})
    poles, order = _poles(plane, values)
    cofactor = _curve(plane, plane.cofactor, values)
    bounds = tuple(_curve(plane, bound.formula, values) for bound in plane.bounds)
    discriminant = cofactor.discriminant("z")
    at_poles = [cofactor.subs({"z": pole}) for pole in poles]
    if discriminant.is_zero() or any(value.is_zero() for value in at_poles):
        raise InputError(
            f"{plane.name}: with these parameters two roots of the curve coincide on every level; "
            "a diagram needs others"
        )
    cut = arrangement([discriminant, *at_poles, *bounds])
    kinds = Kinds(plane, poles, order, cofactor, bounds, cut)
    return Diagram(
        plane=plane,
        parameters=values,
        poles=poles,
        order=order,
        cofactor=cofactor,
        arrangement=cut,
        regions=kinds.regions(),
        boundaries=kinds.boundaries(),
        equilibria=kinds.equilibria(),
    )


def _poles(
    plane: IntegralPlane, values: Mapping[sp.Symbol, Fraction]
) -> tuple[tuple[fmpq, fmpq, fmpq], tuple[int, int, int]]:
    """The poles, increasing, and the body axis of each."""
    exact = [Fraction(str(_number(plane, pole, values))) for pole in plane.poles]
    if len(set(exact)) < 3:
        raise InputError(
            f"{plane.name}: the moments {', '.join(map(str, exact))} must be three different "
            "numbers; with two equal ones the curve loses its genus"
        )
    check_inertia([float(moment) for moment in exact])
    for condition in plane.level:
        if set(condition.free_symbols) <= set(values) and _number(plane, condition, values) != 0:
            raise InputError(
                f"{plane.name}: {text(condition)} must vanish; the system is not known to separate "
                "otherwise"
            )
    axes = sorted((1, 2, 3), key=lambda axis: exact[axis - 1])
    first, second, third = (rational(exact[axis - 1]) for axis in axes)
    return (first, second, third), (axes[0], axes[1], axes[2])


def _number(
    plane: IntegralPlane, formula: sp.Expr, values: Mapping[sp.Symbol, Fraction]
) -> sp.Expr:
    """A formula with definitions and parameter values inserted."""
    known = {s: sp.Rational(x.numerator, x.denominator) for s, x in values.items()}
    constants, _ = by_dependence(plane.system.scalar_definitions, plane.system.symbols)
    return sp.sympify(formula).xreplace(definition_values(constants, known))


def _curve(
    plane: IntegralPlane, formula: sp.Expr, values: Mapping[sp.Symbol, Fraction]
) -> fmpq_mpoly:
    """A polynomial in the two integrals and z with rational coefficients."""
    filled = sp.cancel(sp.expand(_number(plane, formula, values)))
    names = (*(axis.symbol for axis in plane.axes), Z)
    whole = sp.Poly(filled, *names) if filled.is_polynomial(*names) else None
    if whole is None or not all(c.is_Rational for c in whole.coeffs()):
        raise InputError(
            f"{plane.name}: with these parameters the curve is no polynomial of genus two with "
            "rational coefficients; a field needs a strength other than 0"
        )
    return RING.from_dict({powers: fmpq(int(c.p), int(c.q)) for powers, c in whole.terms()})
