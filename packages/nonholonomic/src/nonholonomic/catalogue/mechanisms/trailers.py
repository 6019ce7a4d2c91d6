"""A car that pulls trailers, each hitched at the axle before it (§2.1).

Axle 0 is that of the car, seen as one; axle i follows at the distance l_i.  θ is the heading of the
car and φ_i the angle at hitch i, from trailer i to what pulls it.  Axle i has the velocity a_i
along itself and b_i across, which vanishes:

    a_i = a_{i−1} cos φ_i − b_{i−1} sin φ_i,    b_i = a_{i−1} sin φ_i + b_{i−1} cos φ_i − l_i w_i.

Masses sit at the axles, so that the car turns uniformly.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol

from ...mechanics.lagrangian.mechanism import Frame, Mechanism
from ...mechanics.lagrangian.plan import Plan
from ...mechanics.lagrangian.poincare_suslov import equations_of_motion
from ..catalogue_entry import Numbers, entry_with
from ..positive_numbers import positive

x, y, theta, u, v, m, J = (real_symbol(name) for name in ("x", "y", "theta", "u", "v", "m", "J"))
HALF = sp.Rational(1, 2)
SOURCE = "§2.1"
TITLE = "Car with trailers"
SUMMARY = (
    "A car pulls two trailers, each hitched to the axle in front of it; the car turns at a "
    "constant rate, and the trailers affect only its speed."
)


def drawing_of_trailers(count: int) -> Plan:
    """The axles of a car with a number of trailers, and the drawbars between them."""
    place, heading = (x, y), theta
    axles, links = [(x, y, theta)], []
    for phi, length in zip(
        _numbered_symbols("phi", count), _numbered_symbols("l", count), strict=True
    ):
        heading = heading - phi
        hitch, place = (
            place,
            (
                place[0] - length * sp.cos(heading),
                place[1] - length * sp.sin(heading),
            ),
        )
        axles.append((*place, heading))
        links.append((*hitch, *place))
    return Plan((x, y), tuple(links), axles=tuple(axles))


def _numbered_symbols(name: str, count: int) -> tuple[sp.Symbol, ...]:
    return tuple(real_symbol(f"{name}_{i}") for i in range(1, count + 1))


def train(count: int, values: Mapping[str, float] | None = None) -> Mechanism:
    """A car with a number of trailers.

    Parameters
    ----------
    count : int
        How many trailers.
    values : mapping of str to float, optional
        Parameters: ``m`` and ``J`` of the car, ``m_i``, ``J_i`` and ``l_i`` of trailer i.

    Raises
    ------
    InputError
        If a mass, moment of inertia or length is not positive.
    """
    p = {**_defaults(count), **(values or {})}
    angles, spins = _numbered_symbols("phi", count), _numbered_symbols("w", count)
    lengths, masses, moments = (_numbered_symbols(name, count) for name in ("l", "m", "J"))
    along, across = _numbered_symbols("a", count), _numbered_symbols("b", count)
    turn = real_symbol("Omega")
    definitions: dict[sp.Symbol, sp.Expr] = {}
    # the car does not slip sideways
    constraints: list[sp.Expr] = [v]
    rates = {x: u * sp.cos(theta) - v * sp.sin(theta), y: u * sp.sin(theta) + v * sp.cos(theta)}
    rates[theta] = turn
    kinetic = HALF * m * (u**2 + v**2) + HALF * J * turn**2
    pulling, speed = (u, v, turn), u
    for phi, w, length, mass, moment, a, b in zip(
        angles, spins, lengths, masses, moments, along, across, strict=True
    ):
        forward, sideways, before = pulling
        definitions[a] = forward * sp.cos(phi) - sideways * sp.sin(phi)
        definitions[b] = forward * sp.sin(phi) + sideways * sp.cos(phi) - length * w
        # b = 0, where the axles before do not slip sideways
        constraints.append(w - speed * sp.sin(phi) / length)
        speed = speed * sp.cos(phi)
        rates[phi] = before - w
        kinetic += HALF * mass * (a**2 + b**2) + HALF * moment * w**2
        pulling = (a, b, w)
    return Mechanism(
        name="trailers",
        frame=Frame(rates, (u, v, turn, *spins)),
        lagrangian=kinetic,
        constraints=tuple(constraints),
        definitions=definitions,
        parameters=_parameters(count, p),
        laws=(
            Integral("turning", turn, "angular velocity of the car", source=SOURCE, unit="rad/s"),
        ),
        title=TITLE,
        source=SOURCE,
        summary=SUMMARY,
    )


def _defaults(count: int) -> dict[str, float]:
    defaults = {"m": 1.0, "J": 0.5}
    for i in range(1, count + 1):
        defaults |= {f"m_{i}": 0.6, f"J_{i}": 0.2, f"l_{i}": 1.0 - 0.2 * (i % 2)}
    return defaults


def _parameters(count: int, p: Mapping[str, float]) -> tuple[Parameter, ...]:
    parameters = [positive(m, "mass of the car, at its axle", p["m"], "kg")]
    parameters.append(positive(J, "moment of inertia of the car", p["J"], "kg m^2"))
    for i in range(1, count + 1):
        parameters += [
            positive(real_symbol(f"m_{i}"), f"mass of trailer {i}, at its axle", p[f"m_{i}"], "kg"),
            positive(
                real_symbol(f"J_{i}"), f"moment of inertia of trailer {i}", p[f"J_{i}"], "kg m^2"
            ),
            positive(real_symbol(f"l_{i}"), f"length of trailer {i}", p[f"l_{i}"], "m"),
        ]
    return tuple(parameters)


def trailers(p: Numbers) -> System:
    """Two trailers: the angles at the hitches, the speed and the turning."""
    return equations_of_motion(train(2, p))


ENTRIES = (entry_with(name="trailers", build=trailers, plan=drawing_of_trailers(2)),)
