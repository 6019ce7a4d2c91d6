"""Generalised Chaplygin systems recognised, and the reducing multiplier (§4.3, Theorem 6).

From a Lagrangian, a frame and constraints alone: the two coordinates in which the system moves by
itself, on a level of its linear integrals where it needs them; the form (4.4) with S; whether the
1-form d ln N = A₂ dq₁ − A₁ dq₂ is closed, and N; the bracket (4.6), the gyroscopic form S̄ and its
integral over the base.  No multiplier is built in: everything follows by exact linear algebra at
rational points, and is stated as laws that :mod:`chaplygin.laws` proves.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from ..errors import InputError
from ..notation import text
from ..statements import Identity, Integral, Law
from ..system import System
from .quasivelocity import Mechanism
from .reduction_balance import balanced
from .reduction_base import Base, base
from .reduction_canonical import canonical, canonical_law
from .reduction_closed import Closed, closed_forms
from .reduction_factors import Chart, natural_factors
from .reduction_flux import Flux, flux
from .reduction_integrals import linear_integrals
from .reduction_lift import Lift, Local, lift
from .reduction_motion import Motion, motion
from .reduction_multiplier import Multiplier, Obstruction, closed, multiplier
from .reduction_system import chaplygin_system, motion_law, with_base
from .suslov import equations

__all__ = ["ChaplyginForm", "chaplygin_form"]


@dataclass(frozen=True)
class ChaplyginForm:
    """What Theorem 6 makes of a mechanism.

    Attributes
    ----------
    original : System
        The equations of motion of the mechanism, with its linear integrals as laws.
    base : Base
        The two coordinates.
    integrals : tuple of (Symbol, Expr)
        The linear integrals on whose levels the system is reduced, with their constants.
    role : str
        The integral that plays the part of the energy in L = E₂ − E₀.
    closed : Closed
        Metric, S and the lift, in closed form.
    multiplier : Multiplier or None
        N up to a constant factor.
    obstruction : Obstruction or None
        Where the 1-form is not closed, if there is no multiplier.
    flux : Flux or None
        The integral of S̄, if there is a multiplier.
    system : System
        (4.7), with the laws of Theorem 6 and the way back to `original`.
    hamiltonian : System or None
        The same in the time τ and canonical variables, where S̄ is exact in closed form.
    """

    original: System
    base: Base
    integrals: tuple[tuple[sp.Symbol, sp.Expr], ...]
    role: str
    closed: Closed
    multiplier: Multiplier | None
    obstruction: Obstruction | None
    flux: Flux | None
    system: System
    hamiltonian: System | None

    @property
    def gyroscopic(self) -> sp.Expr:
        """S̄ of (4.5); zero without a multiplier has no meaning, so it is S at rest then."""
        scale = sp.S.One if self.multiplier is None else self.multiplier.value
        return scale * self.closed.b

    def claims(self) -> Iterator[tuple[System, Law]]:
        """All that is claimed, as pairs of a system and a law of it."""
        for system in (self.original, self.system, self.hamiltonian):
            if system is not None:
                yield from ((system, law) for law in system.laws)

    def __str__(self) -> str:
        return "\n".join(_lines(self))


def chaplygin_form(mechanism: Mechanism) -> ChaplyginForm:
    """Recognise a generalised Chaplygin system and find its reducing multiplier.

    Parameters
    ----------
    mechanism : Mechanism
        With constraints linear and homogeneous in the velocities, and coefficients rational in
        its coordinates, their sines and cosines.

    Returns
    -------
    ChaplyginForm

    Raises
    ------
    InputError
        If the system is not of this kind: the sentence says in what it differs.
    """
    moved = motion(mechanism)
    here = base(mechanism, moved)
    found = _integrals(mechanism, moved, here)
    up = lift(here, found)
    chosen = balanced(mechanism, moved, up)
    local = Local(up, chosen.integral, mechanism.name)
    chart = Chart.of(here.coordinates, local.symbols)
    parameters = [p.symbol for p in mechanism.parameters]
    forms = {here.motion.metric.as_immutable(): None}
    forms[chosen.integral.slope.jacobian(here.motion.velocities).as_immutable()] = None
    factors = natural_factors(up, list(forms), chart, parameters, mechanism.name)
    N_found = multiplier(local, chart, factors, here.normal)
    parts = closed_forms(local, chart, parameters, here.normal)
    return _assembled(mechanism, here, up, local, chart, parts, N_found, chosen.words)


def _assembled(
    mechanism: Mechanism,
    here: Base,
    up: Lift,
    local: Local,
    chart: Chart,
    parts: Closed,
    found: Multiplier | None,
    role: str,
) -> ChaplyginForm:
    potential = local.integral.potential
    original = _original(mechanism, here, up)
    made = chaplygin_system(mechanism, here, up.constants, parts, potential, found)
    made = made.with_laws(motion_law(here, parts, original))
    monopole = hamiltonian = None
    if found is not None:
        monopole = flux(mechanism, here, up.constants, found, parts.b)
        made = made.with_laws(*_shape(parts, monopole))
        if monopole.potential is not None:
            hamiltonian = canonical(made, here, parts, potential, found, monopole.potential)
            made = made.with_laws(canonical_law(here, hamiltonian, monopole.potential))
    return ChaplyginForm(
        original=original,
        base=here,
        integrals=tuple(zip(up.constants, up.integrals, strict=True)),
        role=role,
        closed=parts,
        multiplier=found,
        obstruction=closed(local, chart) if found is None else None,
        flux=monopole,
        system=made,
        hamiltonian=hamiltonian,
    )


def _original(mechanism: Mechanism, here: Base, up: Lift) -> System:
    """The equations of motion with the linear integrals as laws."""
    made = with_base(equations(mechanism), here)
    names = [f"linear_{c}" for c in up.constants]
    return made.with_laws(
        *(
            Integral(name, value, "integral linear in the velocities")
            for name, value in zip(names, up.integrals, strict=True)
        )
    )


def _shape(parts: Closed, monopole: Flux) -> tuple[Law, ...]:
    """What the integral of S̄ rests on."""
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


def _integrals(mechanism: Mechanism, moved: Motion, here: Base) -> list[sp.Expr]:
    free = len(moved.velocities) - moved.constraints.rows
    needed = free - 2
    if needed == 0:
        return []
    if moved.constraints.rows:
        raise InputError(
            f"{mechanism.name}: its constraints allow {free} velocities for two coordinates; "
            "linear integrals that take the others are only sought where every constraint gives "
            "a velocity with a number as coefficient"
        )
    found = linear_integrals(mechanism, moved, here)
    if len(found) < needed:
        raise InputError(
            f"{mechanism.name}: its constraints allow {free} velocities for two coordinates, and "
            f"{len(found) or 'no'} integral linear in the momenta, with coefficients up to degree "
            "two in the coordinates, was found to take the others: it is no generalised Chaplygin "
            "system in these coordinates"
        )
    return found[:needed]


def _lines(form: ChaplyginForm) -> Iterator[str]:
    """The page of a form, for a terminal."""
    q = ", ".join(map(text, form.base.coordinates))
    yield f"{form.system.title}"
    yield f"  coordinates  {q}" + (
        "" if form.base.normal is None else f"   ({text(form.base.normal)} on the unit sphere)"
    )
    for constant, value in form.integrals:
        yield f"  level        {text(constant)} = {text(value)}"
    yield f"  L = E₂ − E₀  from {form.role}"
    if form.multiplier is None:
        yield from _refused(form)
        return
    yield f"  multiplier   N = {text(form.multiplier.value)}"
    yield f"  S̄            {text(form.gyroscopic)}"
    if form.flux is not None and form.flux.value is not None:
        yield f"  ∫S̄           {text(form.flux.value)}   ({form.flux.words})"
    elif form.flux is not None:
        yield f"  ∫S̄           not found in closed form: {form.flux.words}"
    if form.hamiltonian is not None:
        yield "  canonical    Hamiltonian in the time τ, dτ = N dt, in global canonical variables"
    elif form.flux is not None and form.flux.value not in (None, 0):
        yield "  canonical    none on the whole sphere: the integral of S̄ is not zero"


def _refused(form: ChaplyginForm) -> Iterator[str]:
    found = form.obstruction
    if found is None:
        yield "  multiplier   undecided: the 1-form is closed, but N is no product of its factors"
        return
    yield "  multiplier   none: d(A₂ dq₁ − A₁ dq₂) ≠ 0"
    values = ", ".join(f"{name} = {value}" for name, value in found.point.items())
    yield f"    it is {found.curl} at {values}"
    if found.vanishing:
        yield f"    it vanishes where {' or '.join(f'{text(f)} = 0' for f in found.vanishing)}"
