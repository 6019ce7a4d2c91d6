"""Recognise uniform motions: rest, permanent rotation, steady precession.

The vectors of the reduced state rotate rigidly in the body, x(t) = e^{−tΩ×} x(0), with a constant
Ω: zero for an equilibrium of the reduced system, along the axis of symmetry for a body of
revolution, ω itself for a permanent rotation (about a principal axis, or about any axis if all
moments are equal). The first two follow from the rates at the start by symmetry; the third is
checked along the rotation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText
from flowlanes.formulas.balls import ball, ball_values, exact
from flowlanes.formulas.relative_zero import SizedNumber, state_sizes, values_with_sizes, vanishes
from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import cross, dot
from flowlanes.system.vectors import Vector

from ...mechanics.rolling.attitude import place_rates
from ..base.exact_start import on_phase_space, with_definitions
from ..base.solution import ClosedForm, NamedConstant
from ..one_degree.uniform import Rotation, UniformSolution
from ..one_degree.vectors import product
from .analytic_formula import velocity
from .exact_start import PRECISION

#: Angles of rotation about ω at which the field is compared with a rigid rotation.
ANGLES = 7

_OMEGA = Vector("omega").symbols

Balls = Sequence[arb]
Values = Mapping[sp.Symbol, arb]


def uniform_solution(
    system: System,
    values: Values,
    start: Balls,
    moments: Balls,
) -> UniformSolution | None:
    """The uniform motion through a start, or None.

    Parameters
    ----------
    system : System
        Whose field commutes with the rotations that keep the moments; not lifted.
    values : mapping of Symbol to arb
        Its parameters.
    start : sequence of arb
        The lifted state, on the phase space.
    moments : three arb
        The principal moments, which determine the symmetry.
    """
    size = len(system.symbols)
    known = with_definitions(system, values, start)
    rates = ball_values(system.rates, known)
    vectors = [start[k : k + 3] for k in range(0, size, 3)]
    changes = [rates[k : k + 3] for k in range(0, size, 3)]
    omega = [known[symbol] for symbol in _OMEGA]
    for turning in (*_axes_of_symmetry(vectors, changes, moments), omega):
        angles = [arb(0)] if turning is not omega else [arb(k) for k in range(ANGLES)]
        if all(
            _turns_rigidly(
                system, values, _turned_vectors(vectors, turning, angle), turning, _length(omega)
            )
            for angle in angles
        ):
            return _solution(system, values, start, vectors, turning, omega)
    return None


def equilibrium_solution(
    system: System, values: Mapping[sp.Symbol, NumberOrText], start: Sequence[NumberOrText]
) -> UniformSolution | None:
    """The motion at rest in the reduced state, if the start is an equilibrium.

    Parameters
    ----------
    system : System
        Of two vectors, whatever its field; not lifted.
    values : mapping of Symbol to number
        Its parameters.
    start : sequence of numbers
        The state, reduced or lifted.

    Raises
    ------
    InputError
        If the start is off the phase space.
    """
    with ctx.workprec(PRECISION):
        known = {symbol: ball(value) for symbol, value in values.items()}
        size = len(system.symbols)
        lifted = [ball(x) for x in start]
        state = on_phase_space(system, (), lifted[:size], known)
        numbers = state_sizes(system.state, system.symbols, [exact(x) for x in state])
        fixed = {s: SizedNumber(exact(x), abs(exact(x))) for s, x in known.items()}
        rates = system.rates
        if not all(
            x.vanishes()
            for x in values_with_sizes(rates, {**fixed, **numbers}, system.scalar_definitions)
        ):
            return None
        definitions = with_definitions(system, known, state)
        zero = [arb(0)] * 3
        vectors = [state[k : k + 3] for k in range(0, size, 3)]
        omega = [definitions.get(symbol, arb(0)) for symbol in _OMEGA]
        return _solution(system, known, (*state, *lifted[size:]), vectors, zero, omega)


def _turned_vectors(vectors: Sequence[Balls], turning: Balls, angle: arb) -> Sequence[Balls]:
    """The reduced state rotated by e^{−angle·Ω×/|Ω|}."""
    length = dot(turning, turning).sqrt()
    if angle == 0:
        return vectors
    half = angle / 2
    back = [half.cos(), *(-half.sin() * x / length for x in turning)]
    return [product(back, vector) for vector in vectors]


def _turns_rigidly(
    system: System,
    values: Values,
    vectors: Sequence[Balls],
    turning: Balls,
    speed: arb,
) -> bool:
    """Whether the rates of all vectors x are −Ω×x at a state, relative to |ω||x|."""
    known = with_definitions(system, values, _midpoints(vectors))
    rates = ball_values(system.rates, known)
    sides = [cross(turning, vector) for vector in vectors]
    return all(
        vanishes((x + y).mid(), speed * _length(vector))
        for number, (vector, side) in enumerate(zip(vectors, sides, strict=True))
        for x, y in zip(rates[3 * number : 3 * number + 3], side, strict=True)
    )


def _length(vector: Balls) -> arb:
    return dot(vector, vector).sqrt()


def _midpoints(vectors: Sequence[Balls]) -> list[arb]:
    return [x.mid() for vector in vectors for x in vector]


def _axes_of_symmetry(
    vectors: Sequence[Balls], changes: Sequence[Balls], moments: Balls
) -> list[Balls]:
    """The possible Ω along an axis of symmetry, and zero."""
    size = max(abs(moment) for moment in moments)
    candidates: list[Balls] = [[arb(0)] * 3]
    equal = [vanishes((moments[(i + 1) % 3] - moments[(i + 2) % 3]).mid(), size) for i in range(3)]
    for i in (i for i in range(3) if equal[i]):
        axis = [arb(int(k == i)) for k in range(3)]
        for vector, change in zip(vectors, changes, strict=True):
            # In a uniform motion every vector perpendicular to the axis turns at the same rate.
            side = cross(axis, vector)
            if not vanishes(_length(side).mid(), _length(vector)):
                share = dot(change, side) / dot(side, side)
                candidates.append([-share * x for x in axis])
                break
    return candidates


def _solution(
    system: System,
    values: Values,
    start: Balls,
    vectors: Sequence[Balls],
    turning: Balls,
    omega: Balls,
) -> UniformSolution:
    size = len(system.symbols)
    known = with_definitions(system, values, start)
    in_space = system.reconstruction is not None
    length = sum((q * q for q in start[size : size + 4]), arb(0)).sqrt()
    # Use exact midpoints: radii near 1e-120 would hide that a difference is zero.
    own, whole = [x.mid() for x in turning], [x.mid() for x in omega]
    spin = Rotation.from_vector(own)
    precession = Rotation.from_vector([w - x for w, x in zip(whole, own, strict=True)])
    figures = (
        NamedConstant("Omega", spin.rate, "rate at which vectors turn in the body", "rad/s"),
        NamedConstant(
            "omega_0", precession.rate, "rate at which that frame turns in space", "rad/s"
        ),
    )
    moving = any(not x.contains(0) for x in whole)
    form = ClosedForm(
        title=system.lifted().title if in_space else system.title,
        motion="uniform rotation" if moving else "rest",
        equations=((sp.Symbol("x"), sp.Symbol("exp(-t*Omega)") * sp.Symbol("x_0")),),
        constants=figures,
    )
    return UniformSolution(
        system.lifted() if in_space else system,
        values,
        vectors=vectors,
        spin=spin,
        precession=precession,
        closed_form=form,
        attitude=[q / length for q in start[size : size + 4]] if in_space else [],
        velocity=ball_values(velocity(place_rates(system)), known),
        position=start[size + 4 :],
    )
