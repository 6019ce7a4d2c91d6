"""Equations of motion from a Lagrangian, a frame and constraints."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from flowlanes import InputError
from flowlanes.system.laws import Identity, Integral, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    Vector,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
)
from lawproof import prove, prove_all
from nonholonomic.mechanics.lagrangian.mechanism import (
    TIME,
    Frame,
    Mechanism,
    coordinates,
    euclidean,
    rotations,
)
from nonholonomic.mechanics.lagrangian.poincare_suslov import derive, equations_of_motion

HALF = sp.Rational(1, 2)
x, y, phi, u, v, w = (real_symbol(n) for n in ("x", "y", "phi", "u", "v", "omega"))
m, a, J, g, l, c = (real_symbol(n) for n in ["m", "a", "J", "g", "l", "c"])
omega, gamma, R = Vector("omega"), Vector("gamma"), Vector("R")
I = Diagonal("I")
xdot, ydot = real_symbol("xdot"), real_symbol("ydot")
SLEIGH = tuple(Parameter(s, "", d) for s, d in ((m, 1.0), (a, 0.3), (J, 0.5)))
PLANE = Frame(
    {x: u * sp.cos(phi) - v * sp.sin(phi), y: u * sp.sin(phi) + v * sp.cos(phi), phi: w}, (u, v, w)
)


def operations(system: System) -> int:
    return int(
        sum(sp.count_ops(f) for f in (*system.rates, *(e for _, e in system.scalar_definitions)))
    )


def sleigh(constraint: sp.Expr = v, **more: Any) -> Mechanism:
    lagrangian = HALF * m * (u**2 + (v + a * w) ** 2) + HALF * J * w**2
    return Mechanism("sleigh", PLANE, lagrangian, (constraint,), parameters=SLEIGH, **more)


def sleigh_in_coordinates(offset: sp.Expr = sp.S.Zero) -> Mechanism:
    frame = coordinates(x, y, phi)
    xdot, ydot, phidot = frame.w
    ahead, beside = (
        xdot * sp.cos(phi) + ydot * sp.sin(phi),
        -xdot * sp.sin(phi) + ydot * sp.cos(phi),
    )
    lagrangian = HALF * m * (ahead**2 + (beside + a * phidot) ** 2) + HALF * J * phidot**2
    return Mechanism("sleigh", frame, lagrangian, (beside - offset,), parameters=SLEIGH)


def test_sleigh_in_its_own_frame_reads_as_in_books() -> None:
    system = equations_of_motion(sleigh())
    assert system.symbols == (u, w)
    assert sp.simplify(system.rates[0] - a * w**2) == 0
    assert sp.simplify(system.rates[1] + m * a * u * w / (J + m * a**2)) == 0
    assert [str(s) for name, _ in system.reconstruction.field for s in [name]] == ["x", "y", "phi"]


def test_rates_may_use_definitions() -> None:
    """The frame is commuted with what its names stand for."""
    c_, s_ = real_symbol("cosine"), real_symbol("sine")
    frame = Frame({x: u * c_ - v * s_, y: u * s_ + v * c_, phi: w}, (u, v, w))
    lagrangian = HALF * m * (u**2 + (v + a * w) ** 2) + HALF * J * w**2
    named = Mechanism(
        "named",
        frame,
        lagrangian,
        (v,),
        definitions={c_: sp.cos(phi), s_: sp.sin(phi)},
        parameters=SLEIGH,
    )
    assert equations_of_motion(named).rates == equations_of_motion(sleigh()).rates


def test_the_reaction_is_the_sideways_force() -> None:
    system = equations_of_motion(sleigh())
    (reaction,) = system.observables
    steps = dict(system.scalar_definitions)
    value = reaction.value
    while value.free_symbols & steps.keys():
        value = value.xreplace(steps)
    # m times the sideways acceleration of the centre of mass, a ω̇ + u ω
    turning = dict(zip(system.symbols, system.rates, strict=True))[w]
    expected = m * (u * w + a * turning)
    assert sp.simplify(value - expected) == 0


def test_two_frames_tell_one_motion() -> None:
    """In coordinates the speed along the blade and the turning obey the same equations."""
    system = equations_of_motion(sleigh_in_coordinates())
    xdot, ydot, phidot = (real_symbol(f"{q}dot") for q in (x, y, phi))
    ahead = xdot * sp.cos(phi) + ydot * sp.sin(phi)
    law = Identity(
        "sleigh",
        (
            Rate(ahead) - a * phidot**2,
            Rate(phidot) + m * a * ahead * phidot / (J + m * a**2),
        ),
    )
    assert prove(system, law).decision == "proven"


def test_an_affine_constraint_breaks_the_energy() -> None:
    system = equations_of_motion(sleigh_in_coordinates(sp.S.One))
    assert system.laws == ()
    assert "not homogeneous" in system.summary
    energy = next(o for o in system.observables if o.name == "energy")
    power = next(o for o in system.observables if o.name == "power")
    claimed = prove(system, Integral("energy", energy.value))
    assert claimed.decision == "refuted"
    rate = Identity("power", Rate(energy.value) - power.value)
    assert prove(system, rate).decision == "proven"


def test_the_energy_theorem_says_what_breaks_it() -> None:
    driven = Mechanism(
        "driven",
        coordinates(x),
        HALF * m * (real_symbol("xdot") + sp.sin(TIME)) ** 2,
        forces={real_symbol("xdot"): -c * real_symbol("xdot")},
        parameters=(Parameter(m, "", 1.0), Parameter(c, "", 0.0)),
    )
    broken = derive(driven).energy.failures
    assert len(broken) == 2
    assert "time enters" in broken[0]
    assert "forces" in broken[1]
    assert equations_of_motion(driven).symbols == (real_symbol("xdot"), TIME)


def test_gyroscopic_forces_keep_the_energy() -> None:
    charged = Mechanism(
        "charged",
        coordinates(x, y),
        HALF * m * (xdot**2 + ydot**2) - x**2 * y,
        forces={xdot: c * ydot, ydot: -c * xdot},
        parameters=(Parameter(m, "", 1.0), Parameter(c, "", 0.4)),
    )
    assert all(verdict.decision == "proven" for verdict in prove_all(equations_of_motion(charged)))


def test_appell_and_hamel() -> None:
    """A constraint quadratic in the velocities, by Chetaev's rule: energy holds, dragging does."""
    frame = coordinates(x, y, real_symbol("z"))
    xdot, ydot, zdot = frame.w
    machine = Mechanism(
        "appell-hamel",
        frame,
        HALF * m * (xdot**2 + ydot**2 + zdot**2) - m * g * real_symbol("z"),
        (zdot**2 - l**2 * (xdot**2 + ydot**2),),
        parameters=tuple(Parameter(s, "", 1.0) for s in (m, g, l)),
    )
    system = equations_of_motion(machine)
    verdicts = {verdict.law: verdict.decision for verdict in prove_all(system)}
    assert verdicts == {"energy": "proven"}
    # known: the horizontal velocity keeps its direction
    law = Identity("straight", xdot * Rate(ydot) - ydot * Rate(xdot))
    assert prove(system, law).decision == "proven"


def test_a_position_constraint_is_kept() -> None:
    l_ = Parameter(l, "length", 1.0)
    speeds = Vector("v")
    pendulum = Mechanism(
        "pendulum",
        Frame({R: speeds}, (speeds,)),
        HALF * m * norm_squared(speeds) - m * g * R.symbols[2],
        positions=(norm_squared(R) - l**2,),
        parameters=(Parameter(m, "", 1.0), Parameter(g, "", 9.8), l_),
    )
    system = equations_of_motion(pendulum)
    assert len(system.relations) == 2
    about = Integral("K", R.symbols[0] * speeds.symbols[1] - R.symbols[1] * speeds.symbols[0])
    assert prove(system, about).decision == "proven"
    assert prove(system, "energy").decision == "proven"


def test_suslov_with_a_constraint_that_stays() -> None:
    """(ω, n) = 0 in body axes, n of any direction: (1.9) in the group frame of the rotations."""
    n = Vector("n")
    parameters = [Parameter(s, "", 1.0 + i / 3) for i, s in enumerate((*I.symbols, *n.symbols))]
    body = Mechanism(
        "suslov",
        Frame({}, (omega,), structure=rotations(omega)),
        HALF * dot(omega, I * omega),
        (dot(omega, n),),
        parameters=tuple(parameters),
    )
    system = equations_of_motion(body)
    assert prove(system, "energy").decision == "proven"
    turning = Vector("turning")
    euler = I * turning - cross(I * omega, omega)
    rates = dict(zip(turning.symbols, (Rate(s) for s in omega.symbols), strict=True))
    law = Identity("parallel to n", to_components(cross(euler, n)).xreplace(rates))
    assert prove(system, law).decision == "proven"


def test_massless_coordinates_are_led_by_constraints() -> None:
    """A wheel without inertia of its own: the mass matrix alone is singular, the motion is not."""
    theta = real_symbol("theta")
    frame = coordinates(x, theta)
    xdot, turning = frame.w
    rolling = Mechanism(
        "wheel",
        frame,
        HALF * m * xdot**2 + m * g * sp.sin(a) * x,
        (l * sp.sin(x) * turning - xdot,),
        parameters=tuple(Parameter(s, "", 0.7) for s in (m, g, a, l)),
    )
    system = equations_of_motion(rolling)
    assert prove(system, "energy").decision == "proven"


def test_a_momentum_keeps_the_place_it_depends_on() -> None:
    """A charge in a uniform field: ẏ + Bx is conserved, x does not enter the equations."""
    charge = Mechanism(
        "charge",
        coordinates(x, y),
        HALF * (xdot**2 + ydot**2) + c * x * ydot,
        parameters=(Parameter(c, "", 0.4),),
    )
    system = equations_of_motion(charge)
    assert system.symbols == (x, xdot, ydot)
    assert {verdict.decision for verdict in prove_all(system)} == {"proven"}


def test_momenta_of_cyclic_velocities() -> None:
    frame = coordinates(real_symbol("r"), phi)
    rdot, phidot = frame.w
    r = real_symbol("r")
    planet = Mechanism(
        "planet",
        frame,
        HALF * m * (rdot**2 + r**2 * phidot**2) + g * m / r,
        parameters=(Parameter(m, "", 1.0), Parameter(g, "", 1.0)),
    )
    system = equations_of_motion(planet)
    assert [law.name for law in system.laws] == ["energy", "momentum_phidot"]
    assert all(verdict.decision == "proven" for verdict in prove_all(system))
    assert phi not in system.symbols


@pytest.mark.slow
@given(seed=st.integers(0, 10**6))
@settings(max_examples=10)
def test_any_quadratic_lagrangian_with_any_linear_constraint_keeps_its_energy(seed: int) -> None:
    import random

    rng = random.Random(seed)

    def number() -> sp.Rational:
        return sp.Rational(rng.randint(-9, 9), rng.randint(2, 7))

    frame = coordinates(x, y, real_symbol("z"))
    places, speeds = frame.coordinates, frame.w
    root = [[number() + number() * s for s in places] for _ in range(3)]
    squares = [sp.Add(*(e * s for e, s in zip(row, speeds, strict=True))) ** 2 for row in root]
    potential = number() * x**2 + number() * x * y + number() * places[2]
    kinetic = HALF * sp.Add(*squares, *(s**2 for s in speeds))
    f = sp.Add(*((number() + number() * q) * s for q, s in zip(places, speeds, strict=True)))
    system = equations_of_motion(
        Mechanism("any", frame, kinetic - potential, (f + speeds[0] / 11,))
    )
    assert prove(system, "energy").decision == "proven"


# --- sizes -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("make", "most"),
    [
        (sleigh, 30),
        (sleigh_in_coordinates, 120),
    ],
)
def test_expressions_stay_small(make: Any, most: int) -> None:
    assert operations(equations_of_motion(make())) <= most


@pytest.mark.parametrize(("model", "most"), [("marble", 200), ("rubber", 300)])
def test_a_rolling_ball_takes_few_operations(model: str, most: int) -> None:
    speed = Vector("v")
    ball = Mechanism(
        "ball",
        Frame(
            {gamma: cross(gamma, omega)},
            (omega, speed),
            (norm_squared(gamma) - 1,),
            euclidean(omega, speed),
        ),
        HALF * m * norm_squared(speed) + HALF * dot(omega, I * omega),
        (speed - cross(omega, l * gamma), *([dot(omega, gamma)] if model == "rubber" else [])),
        parameters=tuple(Parameter(s, "", 1.0) for s in (m, l, *I.symbols)),
    )
    assert operations(equations_of_motion(ball)) <= most


# --- mistakes --------------------------------------------------------------------------------

xdot, ydot = real_symbol("xdot"), real_symbol("ydot")
MISTAKES = {
    "follows from the constraints before it": dict(
        frame=coordinates(x, y),
        lagrangian=xdot**2 + ydot**2,
        constraints=(y * xdot - ydot, 2 * y * xdot - 2 * ydot),
    ),
    "contradicts the constraints before it": dict(
        frame=coordinates(x, y),
        lagrangian=xdot**2 + ydot**2,
        constraints=(y * xdot - ydot, y * xdot - ydot - 1),
    ),
    "does not restrict the velocities": dict(
        frame=coordinates(x, y), lagrangian=xdot**2 + ydot**2, constraints=(x - y,)
    ),
    "gives no inertia to ydot": dict(frame=coordinates(x, y), lagrangian=xdot**2 - y**2),
    "which is neither a coordinate": dict(
        frame=coordinates(x, y),
        lagrangian=xdot**2 + ydot**2,
        constraints=(real_symbol("q") * xdot,),
    ),
    "the frame does not span": dict(
        frame=Frame({x: u, y: u}, (u,)), lagrangian=u**2, constraints=()
    ),
    "its 2 fields have rank 1": dict(
        frame=Frame({x: u + 2 * v}, (u, v)), lagrangian=u**2 + v**2, constraints=()
    ),
    "is not tangent to the relation": dict(
        frame=Frame({x: u, y: v}, (u, v), (x**2 + y**2 - 1,)), lagrangian=u**2 + v**2
    ),
    "the field of omega_1 is not tangent": dict(
        frame=Frame(
            {gamma: cross(gamma, omega) + omega},
            (omega,),
            (norm_squared(gamma) - 1,),
            rotations(omega),
        ),
        lagrangian=norm_squared(omega),
    ),
    "uses the velocity xdot": dict(
        frame=coordinates(x, y), lagrangian=xdot**2 + ydot**2, positions=(x * xdot,)
    ),
    "is singular where it holds": dict(
        frame=coordinates(x, y), lagrangian=xdot**2 + ydot**2, constraints=((xdot - y * ydot) ** 2,)
    ),
    "no velocity was found": dict(
        frame=coordinates(x, y), lagrangian=xdot**2 + ydot**2, constraints=(xdot**2 + ydot**2 + 1,)
    ),
    "is negative for some motions": dict(
        frame=coordinates(x, y), lagrangian=xdot**2 - ydot**2, constraints=()
    ),
    "leave nothing free to move": dict(
        frame=coordinates(x, y), lagrangian=xdot**2 + ydot**2, constraints=(xdot, ydot)
    ),
    "constraints must be a sequence of SymPy expressions": dict(
        frame=coordinates(x), lagrangian=xdot**2, constraints=xdot
    ),
    "lagrangian must be a SymPy expression, not the text": dict(
        frame=coordinates(x), lagrangian="xdot**2"
    ),
    "no configuration was found": dict(
        frame=coordinates(x, y), lagrangian=xdot**2 + ydot**2, positions=(x**2 + y**2 + 1,)
    ),
}


@pytest.mark.parametrize("words", MISTAKES)
def test_a_mistake_gets_one_sentence(words: str) -> None:
    with pytest.raises(InputError, match=words):
        equations_of_motion(Mechanism("wrong", **MISTAKES[words]))


def test_formulas_with_a_domain() -> None:
    """Generic points are sought where every formula has a real value."""
    well = Mechanism(
        "well",
        coordinates(x, y),
        HALF * m * (xdot**2 + ydot**2) - sp.log(x) * sp.sqrt(1 - y),
        parameters=(Parameter(m, "", 1.0),),
    )
    assert prove(equations_of_motion(well), "energy").decision == "proven"
    with pytest.raises(InputError, match="no configuration was found"):
        equations_of_motion(Mechanism("nowhere", coordinates(x), xdot**2 - sp.sqrt(-1 - x**2)))


def test_rates_are_linear_in_the_velocities() -> None:
    with pytest.raises(InputError, match="linear and homogeneous"):
        Frame({x: u**2}, (u,))
    with pytest.raises(InputError, match="linear and homogeneous"):
        Frame({x: u + 1}, (u,))


def test_a_name_stands_for_one_thing() -> None:
    with pytest.raises(InputError, match="x stands for two things"):
        Frame({x: x}, (x,))
