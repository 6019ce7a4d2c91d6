"""The snakeboard (§2.1): a board on two pairs of wheels that steer against each other, and a rotor.

(x, y) is the middle of the board, θ its heading and ψ the angle of the rotor against the board.
The front wheels turn by φ, the rear ones by −φ.  In board axes the velocity of the middle is
(u, v), and Ω the angular velocity of the board; no slip across the wheels says v = 0 and
u sin φ = l Ω cos φ, that is, u = l s cos φ and Ω = s sin φ, with a velocity s that neither
straight nor crossed wheels make singular.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol

from ...mechanics.lagrangian.mechanism import Frame, Mechanism
from ...mechanics.lagrangian.plan import Plan
from ...mechanics.lagrangian.poincare_suslov import equations
from ..catalogue_entry import Entry, Numbers, Start
from ..positive_numbers import positives

x, y, theta, psi, phi = (real_symbol(name) for name in ("x", "y", "theta", "psi", "phi"))
s, n, v, spin, steer, u, Omega = (
    real_symbol(name) for name in ("s", "n", "v", "w", "phidot", "u", "Omega")
)
m, J, J_0, J_1, K, ell = (real_symbol(name) for name in ("m", "J", "J_0", "J_1", "K", "l"))

HALF = sp.Rational(1, 2)
SOURCE = "§2.1; A. M. Bloch, P. S. Krishnaprasad, J. E. Marsden, R. M. Murray 1996"
TITLE = "Snakeboard"
SUMMARY = (
    "A board on two pairs of wheels that steer against each other, with a rotor on top; turning "
    "the wheels and the rotor moves it forward, without any push against the ground."
)


def board(p: Numbers) -> Mechanism:
    """The board in the velocities s, n (both constraints are n = 0 and v = 0), v, w = ψ̇, φ̇.

    Raises
    ------
    InputError
        If the mass or a moment of inertia is not positive, or the length is not.
    """
    cosine, sine = sp.cos(phi), sp.sin(phi)
    return Mechanism(
        name="snakeboard",
        frame=Frame(
            {
                x: ell * (s * cosine - n * sine) * sp.cos(theta) - v * sp.sin(theta),
                y: ell * (s * cosine - n * sine) * sp.sin(theta) + v * sp.cos(theta),
                theta: s * sine + n * cosine,
                psi: spin,
                phi: steer,
            },
            (s, n, v, spin, steer),
            structure={
                (s, n): {v: -ell},
                (s, v): {s: -sine * cosine / ell, n: sine**2 / ell},
                (n, v): {s: -(cosine**2) / ell, n: sine * cosine / ell},
                (steer, s): {n: sp.S.One},
                (steer, n): {s: -sp.S.One},
            },
        ),
        lagrangian=HALF * m * (u**2 + v**2)
        + HALF * K * Omega**2
        + HALF * J_0 * (2 * Omega + spin) * spin
        + J_1 * steer**2,
        constraints=(v, n),
        definitions={
            K: J + J_0 + 2 * J_1,
            u: ell * (s * cosine - n * sine),
            Omega: s * sine + n * cosine,
        },
        parameters=_parameters(p),
        laws=(
            Integral(
                "steering", steer, "angular velocity of steering", source=SOURCE, unit="rad/s"
            ),
            Measure(
                "measure",
                {(K - J_0) * sine**2 + m * ell**2 * cosine**2: HALF},
                "measure, smooth for straight and crossed wheels alike",
                source=SOURCE,
            ),
        ),
        title=TITLE,
        source=SOURCE,
        summary=SUMMARY,
    )


def _parameters(p: Numbers) -> tuple[Parameter, ...]:
    meanings = {
        m: ("mass", "kg"),
        J: ("moment of inertia of the board", "kg m^2"),
        J_0: ("moment of inertia of the rotor", "kg m^2"),
        J_1: ("moment of inertia of each wheel pair about its pivot", "kg m^2"),
        ell: ("distance of each wheel pair from the middle", "m"),
    }
    return positives(p, meanings)


def snakeboard(p: Numbers) -> System:
    """Steering angle, the velocity s and those of rotor and steering."""
    return equations(board(p))


_HALF_BOARD = (ell * sp.cos(theta), ell * sp.sin(theta))
_FRONT = (x + _HALF_BOARD[0], y + _HALF_BOARD[1])
_REAR = (x - _HALF_BOARD[0], y - _HALF_BOARD[1])
#: The rotor is a short rod across the middle of the board.
_ROTOR = (ell * sp.cos(theta + psi) / 3, ell * sp.sin(theta + psi) / 3)
PLAN = Plan(
    (x, y),
    links=(
        (*_REAR, *_FRONT),
        (x - _ROTOR[0], y - _ROTOR[1], x + _ROTOR[0], y + _ROTOR[1]),
    ),
    axles=((*_FRONT, theta + phi), (*_REAR, theta - phi)),
)

DEFAULTS = {"m": 4.0, "J": 0.06, "J_0": 0.05, "J_1": 0.01, "l": 0.3}

ENTRIES = (
    Entry(
        name="snakeboard",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=DEFAULTS,
        build=snakeboard,
        plan=PLAN,
        start=Start(state={"phi": 0.2, "s": 0.5, "w": 3.0, "phidot": 0.4}, until=15.0),
        variables={
            "phi": ("angle of the front wheels", "rad"),
            "s": ("rate of rolling, in u = l s cos φ and Ω = s sin φ", "rad/s"),
            "w": ("angular velocity of the rotor against the board", "rad/s"),
            "phidot": ("angular velocity of steering", "rad/s"),
            "x": ("middle of the board", "m"),
            "y": ("middle of the board", "m"),
            "theta": ("heading of the board", "rad"),
            "psi": ("angle of the rotor against the board", "rad"),
        },
    ),
)
