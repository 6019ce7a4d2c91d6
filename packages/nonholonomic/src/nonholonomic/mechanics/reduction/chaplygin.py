"""Generalised Chaplygin systems and the reducing multiplier (§4.3, Theorem 6).

From Lagrangian, frame and constraints follow: two coordinates in which the equations are closed, on
a level of linear integrals if necessary; the form (4.4) with S; whether the 1-form d ln N = A₂ dq₁
− A₁ dq₂ is closed, and N; the bracket (4.6), the gyroscopic form S̄ and its integral over the base.
No multiplier is assumed: everything follows by exact linear algebra at rational points, and is
stated as laws that :mod:`lawproof.proof` proves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import exact_number, with_exact_decimals
from flowlanes.system.laws import Identity, Integral, Law
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol

from ..lagrangian.mechanism import Mechanism
from ..lagrangian.poincare_suslov import equations_of_motion
from ..lagrangian.substituted_parameters import with_parameters
from .base_coordinates import Base, base
from .canonical import canonical, canonical_law
from .closed_form import ClosedFormParts, closed_forms
from .factors import HalfAngleChart, natural_factors
from .gyroscopic_form import Flux, flux, indefinite_factors
from .horizontal_lift import Lift, PointwiseForm, lift
from .integrals import Linear, linear_integrals
from .momenta import ReducedMomenta, motion
from .multiplier import Multiplier, is_closed, multiplier, obstruction_point, over_rational, poles
from .quadratic_integral import energy_like_integral
from .reduced_form import ChaplyginForm
from .reduced_system import chaplygin_system, motion_law, with_base, with_carried_coordinates


@arguments_checked
def chaplygin_form(
    mechanism: Mechanism, levels: Sequence[float | sp.Expr] | None = None
) -> ChaplyginForm:
    """Recognise a generalised Chaplygin system and find its reducing multiplier.

    Parameters
    ----------
    mechanism : Mechanism
        Constraints must be linear and homogeneous in the velocities, and coefficients rational in
        the coordinates, their sines and cosines.
    levels : sequence of numbers or symbols, optional
        Values of the linear integrals used in the reduction, such as ``[0]``; by default they are
        arbitrary constants.

    Returns
    -------
    ChaplyginForm

    Raises
    ------
    InputError
        If the system is not of this kind; the message gives the reason.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, z, xdot, ydot, zdot = sp.symbols("x y z xdot ydot zdot", real=True)
    >>> lagrangian, constraint = (xdot**2 + ydot**2 + zdot**2) / 2, zdot - y * xdot
    >>> particle = nonholonomic.Mechanism(
    ...     "particle", nonholonomic.coordinates(x, y, z), lagrangian, (constraint,)
    ... )
    >>> nonholonomic.chaplygin_form(particle).multiplier.value
    1/sqrt(y**2 + 1)
    """
    form = _reduction(mechanism, levels)
    special = _special(mechanism, form)
    if special is None:
        return form
    level, value = special
    inner = chaplygin_form(with_parameters(mechanism, value), levels)
    return replace(inner, level=(level, *inner.level))


def _special(
    mechanism: Mechanism, form: ChaplyginForm
) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]] | None:
    """The exceptional relation that the values of the parameters satisfy, if any.

    It is returned with the parameter that it determines.
    """
    numbers = {p.symbol: exact_number(p.default) for p in mechanism.parameters}
    excepted = poles(form.multiplier) if form.multiplier is not None else ()
    if form.obstruction is not None:
        excepted = form.obstruction.vanishing
    for factor in excepted:
        if factor.xreplace(numbers) != 0:
            continue
        for symbol in sorted(factor.free_symbols & set(numbers), key=str):
            slope = sp.diff(factor, symbol)
            # linear in the symbol, with a coefficient that does not vanish for the given values
            if not slope.has(symbol) and slope.xreplace(numbers) != 0:
                value = sp.cancel(symbol - factor / slope)
                return symbol - value, {symbol: value}
    return None


def _reduction(mechanism: Mechanism, levels: Sequence[float | sp.Expr] | None) -> ChaplyginForm:
    """The reduction for generic parameters near their values."""
    moved = motion(mechanism)
    here = base(mechanism, moved)
    integrals = _integrals(mechanism, moved, here)
    up = lift(here, integrals, _levels(mechanism, len(integrals), levels))
    chosen = energy_like_integral(mechanism, moved, up)
    local = PointwiseForm(up, chosen.integral, mechanism.name)
    chart = HalfAngleChart.of(here.coordinates, local.symbols)
    parameters = [p.symbol for p in mechanism.parameters]
    forms = {here.motion.metric.as_immutable(): None}
    forms[chosen.integral.slope.jacobian(here.motion.velocities).as_immutable()] = None
    factors = natural_factors(up, list(forms), chart, parameters, mechanism.name)
    N_found = multiplier(local, chart, factors, here.normal)
    parts = closed_forms(local, chart, parameters, here.normal)
    return _form(mechanism, here, up, local, chart, parts, N_found, chosen.words)


def _form(
    mechanism: Mechanism,
    here: Base,
    up: Lift,
    local: PointwiseForm,
    chart: HalfAngleChart,
    parts: ClosedFormParts,
    multiplier: Multiplier | None,
    role: str,
) -> ChaplyginForm:
    potential = local.integral.potential
    original = _original(mechanism, here, up)
    system = chaplygin_system(mechanism, here, up.constants, parts, potential, multiplier)
    extended = with_carried_coordinates(system, here, parts, original)
    way_back = motion_law(here, parts, original, up.level_expressions)
    if extended is None:
        system = system.with_laws(way_back)
    else:
        extended = replace(extended, laws=(way_back,))
    monopole = hamiltonian = gyroscopic = None
    if multiplier is not None:
        gyroscopic = over_rational(multiplier, parts.b)
        monopole = flux(mechanism, here, up.constants, multiplier, parts.b)
        system = system.with_laws(*_shape(monopole))
        if monopole.potential is not None:
            hamiltonian = canonical(system, here, parts, potential, multiplier, monopole.potential)
            system = system.with_laws(canonical_law(here, hamiltonian, monopole.potential))
    obstruction = None if multiplier else obstruction_point(local, chart, mechanism.parameters)
    return ChaplyginForm(
        original=original,
        base=here,
        integrals=tuple(zip(up.levels, up.integrals, strict=True)),
        role=role,
        closed=parts,
        multiplier=multiplier,
        obstruction=obstruction,
        closed_form=bool(multiplier) or (obstruction is None and is_closed(local, chart)),
        singular=() if multiplier is None else indefinite_factors(mechanism, here, multiplier),
        flux=monopole,
        system=system,
        gyroscopic=gyroscopic,
        lifted=extended,
        hamiltonian=hamiltonian,
        local=local,
    )


def _original(mechanism: Mechanism, here: Base, up: Lift) -> System:
    """The equations of motion with the linear integrals as laws."""
    system = with_base(equations_of_motion(mechanism), here)
    names = [f"linear_{i + 1}" for i in range(len(up.integrals))]
    return system.with_laws(
        *(
            Integral(name, each.value, "integral linear in the velocities")
            for name, each in zip(names, up.integrals, strict=True)
        )
    )


def _shape(monopole: Flux) -> tuple[Law, ...]:
    """The identity used in the integral of S̄, if it is not trivial."""
    if monopole.residual == 0:
        return ()
    return (
        Identity(
            "gyroscopic_form",
            monopole.residual,
            "S̄ over the irrational part of N: a solid angle and an exact form",
            source="(4.5)",
        ),
    )


def _levels(
    mechanism: Mechanism, count: int, values: Sequence[float | sp.Expr] | None
) -> list[sp.Expr]:
    """The given values of the linear integrals, or new constants."""
    if values is not None:
        if len(values) != count:
            raise InputError(
                f"{mechanism.name}: {len(values)} levels are given, but it is reduced on levels of "
                f"{count} linear integrals"
            )
        return [with_exact_decimals(c) for c in values]
    used = {p.symbol for p in mechanism.parameters} | set(mechanism.symbols)
    used |= {s for s, _ in mechanism.steps}
    names = ["c"] if count == 1 else [f"c_{i + 1}" for i in range(count)]
    return [
        real_symbol(n) if real_symbol(n) not in used else real_symbol(f"level_{n}") for n in names
    ]


def _integrals(mechanism: Mechanism, momenta: ReducedMomenta, here: Base) -> list[Linear]:
    free = len(momenta.velocities) - momenta.constraints.rows
    needed = free - 2
    if needed == 0:
        return []
    if momenta.constraints.rows:
        raise InputError(
            f"{mechanism.name}: its constraints allow {free} velocities for two coordinates; "
            "linear integrals that take the others are only sought where every constraint gives "
            "a velocity with a number as coefficient"
        )
    integrals = linear_integrals(mechanism, momenta, here)
    if len(integrals) < needed:
        raise InputError(
            f"{mechanism.name}: its constraints allow {free} velocities for two coordinates, and "
            f"{len(integrals) or 'no'} integral linear in the momenta, with coefficients up to "
            "degree two in the coordinates, was found to take the others; it is not shown to be a "
            "generalised Chaplygin system"
            + (
                " for general values of its parameters (put special values in as numbers)"
                if mechanism.parameters
                else ""
            )
        )
    return integrals[:needed]
