"""Lagrange models and systems of joints of SymPy taken in: the same motions."""

from __future__ import annotations

import random
from collections.abc import Mapping
from typing import Any

import mpmath
import pytest
import sympy as sp
from sympy.physics.mechanics import (
    Force,
    LagrangesMethod,
    Lagrangian,
    Particle,
    PinJoint,
    Point,
    PrismaticJoint,
    ReferenceFrame,
    RigidBody,
    System as SympySystem,
    Torque,
    dynamicsymbols,
    inertia,
)

from flowlanes import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof import prove
from nonholonomic.mechanics.constraints.integrability import nonholonomy
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.mechanics.sympy_models.conversion import from_sympy, mechanism_from_sympy

N = ReferenceFrame("N")
t = dynamicsymbols._t
m, g, length, k = sp.symbols("m g l k", positive=True)
q, u = dynamicsymbols("q u")


def value(formula: sp.Expr, point: Mapping[sp.Symbol, Any]) -> Any:
    symbols = sorted(formula.free_symbols, key=str)
    return sp.lambdify(symbols, formula, "mpmath")(*(point[s] for s in symbols))


def rates_at(system: System, point: Mapping[sp.Symbol, Any]) -> dict[str, Any]:
    known = dict(point)
    for symbol, formula in system.scalar_definitions:
        known[symbol] = value(formula, known)
    pairs = zip(system.symbols, system.rates, strict=True)
    return {str(symbol): value(rate, known) for symbol, rate in pairs}


def agrees_with_sympy(system: System, method: Any, unknown: list[Any]) -> None:
    """SymPy's mass matrix times our accelerations is SymPy's forcing, to 40 digits."""
    rng = random.Random(7)
    with mpmath.workdps(50):
        point = {s: mpmath.mpf(rng.randint(1, 99)) / 101 for s in system.symbols}
        point |= {p.symbol: mpmath.mpf(repr(p.default)) for p in system.parameters}
        plain: dict[Any, Any] = {
            x.diff(t): real_symbol(f"{x.func}dot") for x in method.q if x.diff(t) in method.u
        }
        plain |= {f: real_symbol(str(f.func)) for f in (*method.q, *method.u) if f.is_Function}
        plain |= {s: real_symbol(str(s)) for s in method.mass_matrix.free_symbols - {t}}
        plain |= {s: real_symbol(str(s)) for s in method.forcing.free_symbols - {t}}
        rates = rates_at(system, point)
        matrix = method.mass_matrix.xreplace(plain)
        forcing = method.forcing.xreplace(plain)
        for i in range(matrix.rows):
            left = mpmath.fsum(
                value(entry, point) * rates[name]
                for entry, name in zip(matrix.row(i), unknown, strict=True)
            )
            assert abs(left - value(forcing[i], point)) < mpmath.mpf("1e-40")


# --- Lagrange's method -----------------------------------------------------------------------


def knife_edge() -> LagrangesMethod:
    """A sleigh on a slope: a blade that does not slip sideways."""
    x, y, phi = dynamicsymbols("x y phi")
    blade = N.orientnew("A", "Axis", [phi, N.z])
    origin, centre = Point("O"), Point("C")
    origin.set_vel(N, 0)
    centre.set_pos(origin, x * N.x + y * N.y)
    centre.set_vel(N, centre.pos_from(origin).dt(N))
    body = RigidBody("S", centre, blade, m, (inertia(blade, 0, 0, k), centre))
    body.potential_energy = -m * g * x
    return LagrangesMethod(
        Lagrangian(N, body),
        [x, y, phi],
        nonhol_coneqs=[centre.vel(N).dot(blade.y)],
        forcelist=[(blade, -length * phi.diff(t) * N.z)],
        frame=N,
    )


def test_lagranges_method_with_a_nonholonomic_constraint():
    method = knife_edge()
    numbers = {"m": 2.0, "g": 1.5, "k": 0.5, "l": 0.25}
    mechanism = mechanism_from_sympy(method, numbers)
    assert nonholonomy(mechanism).verdict == "completely nonholonomic"
    system = from_sympy(method, numbers)
    turn = real_symbol("phidot")
    law = Identity("turning", Rate(turn) + real_symbol("l") * turn / real_symbol("k"))
    assert prove(system, law).decision == "proven"
    names = {o.name for o in system.observables}
    assert "lambda_1" in names


def test_a_multiplier_is_sympys_with_the_other_sign():
    method = knife_edge()
    method.form_lagranges_equations()
    point = {
        "x": 0,
        "y": 0,
        "phi": 0.3,
        "xdot": 2 * sp.cos(0.3),
        "ydot": 2 * sp.sin(0.3),
        "phidot": 0.7,
    }
    numbers = {m: 2.0, g: 1.5, k: 0.5, length: 0.25}
    rates = {x.diff(t): point[f"{x.func}dot"] for x in method.q}
    here = {**rates, **{x: point[str(x.func)] for x in method.q}, **numbers}
    theirs = next(iter(method.solve_multipliers(op_point=here).values()))
    system = from_sympy(method, {str(s): value for s, value in numbers.items()})
    known = {s: mpmath.mpf(float(point[str(s)])) for s in system.symbols}
    known |= {p.symbol: mpmath.mpf(p.default) for p in system.parameters}
    for symbol, formula in system.scalar_definitions:
        known[symbol] = value(formula, known)
    ours = next(o for o in system.observables if o.name == "lambda_1")
    assert float(value(ours.value, known)) == pytest.approx(-float(theirs), rel=1e-13)


def test_a_holonomic_constraint_becomes_a_relation():
    x, y = dynamicsymbols("x y")
    place = Point("P")
    place.set_vel(N, x.diff(t) * N.x + y.diff(t) * N.y)
    bob = Particle("B", place, m)
    bob.potential_energy = m * g * y
    method = LagrangesMethod(
        Lagrangian(N, bob), [x, y], hol_coneqs=[x**2 + y**2 - length**2], frame=N
    )
    system = from_sympy(method, {"m": 1, "g": 9.81, "l": 2})
    x_, y_ = real_symbol("x"), real_symbol("y")
    assert x_**2 + y_**2 - real_symbol("l") ** 2 in system.relations
    assert {law.name for law in system.integrals} == {"energy"}
    assert prove(system, "energy").decision == "proven"


# --- System ----------------------------------------------------------------------------------


def cart() -> SympySystem:
    """A cart on a rail with a pendulum, made of joints."""
    x, v, phi, w = dynamicsymbols("x v phi w")
    rail = RigidBody("rail")
    wagon, rod = RigidBody("wagon", mass=m), RigidBody("rod", mass=k)
    system = SympySystem.from_newtonian(rail)
    slide = PrismaticJoint("slide", rail, wagon, x, v, joint_axis=rail.frame.x)
    pin = PinJoint(
        "pin",
        wagon,
        rod,
        phi,
        w,
        joint_axis=wagon.frame.z,
        child_point=length * rod.frame.y,
    )
    system.add_joints(slide, pin)
    system.apply_uniform_gravity(-g * system.y)
    system.add_loads(Force(wagon.masscenter, sp.Symbol("F") * system.x))
    return system


def test_a_system_of_joints():
    model = cart()
    numbers = {"m": 3.0, "k": 1.0, "l": 0.5, "g": 9.81, "F": 2.0, "rod_izz": 0.2}
    system = from_sympy(model, numbers)
    assert model.eom_method is None
    assert [str(s) for s in system.symbols] == ["x", "phi", "v", "w"]
    model.form_eoms()
    agrees_with_sympy(system, model.eom_method, ["v", "w"])
    assert from_sympy(model, numbers).symbols == system.symbols


def test_a_system_whose_speeds_are_rates_goes_by_lagranges_method():
    wall, place = RigidBody("W"), Particle("P", mass=m)
    model = SympySystem.from_newtonian(wall)
    model.add_joints(PrismaticJoint("J", wall, place, q, q.diff(t)))
    model.add_loads(Force(place, -k * q * model.x))
    system = from_sympy(model, {"m": 1, "k": 4})
    law = Identity(
        "spring", Rate(real_symbol("qdot")) + real_symbol("k") * real_symbol("q") / real_symbol("m")
    )
    assert prove(system, law).decision == "proven"
    assert model.eom_method is None


@pytest.mark.slow
def test_a_constraint_on_places_is_not_counted_twice():
    """Two rods whose end keeps to a line: SymPy differentiates the constraint for its speeds."""
    a, b, u_a, u_b = dynamicsymbols("a b u_a u_b")
    wall, first, second = RigidBody("W"), RigidBody("r1"), RigidBody("r2")
    model = SympySystem.from_newtonian(wall)
    model.add_joints(
        PinJoint(
            "J1", wall, first, a, u_a, joint_axis=wall.frame.z, child_point=length * first.frame.x
        ),
        PinJoint(
            "J2",
            first,
            second,
            b,
            u_b,
            joint_axis=first.frame.z,
            parent_point=-length * first.frame.x,
            child_point=length * second.frame.x,
        ),
    )
    model.apply_uniform_gravity(-g * model.y)
    model.q_ind, model.q_dep, model.u_ind, model.u_dep = [a], [b], [u_a], [u_b]
    end = second.masscenter.locatenew("E", -length * second.frame.x)
    model.add_holonomic_constraints(end.pos_from(model.fixed_point).dot(model.y))
    numbers = {"l": 1, "g": 9.81, "r1_mass": 1, "r2_mass": 2, "r1_izz": 0.1, "r2_izz": 0.2}
    system = from_sympy(model, numbers)
    assert len(system.relations) == 2
    mechanism = mechanism_from_sympy(model, numbers)
    assert len(mechanism.positions) == 1
    assert not mechanism.constraints
    ours = equations_of_motion(mechanism)
    start = {"a": 0.4, "b": -0.8, "u_a": 0.5, "u_b": -1.0}
    runs = [
        integrate(s, [start[str(symbol)] for symbol in s.symbols], [0.0, 0.2, 0.4])
        for s in (system, ours)
    ]
    assert runs[0].states == pytest.approx(runs[1].states, rel=1e-12)


def test_a_system_formed_by_lagranges_method_keeps_it():
    place = Particle("P", mass=m)
    wall = RigidBody("W")
    model = SympySystem.from_newtonian(wall)
    place.potential_energy = k * q**2 / 2
    model.add_joints(PrismaticJoint("J", wall, place, q, q.diff(t)))
    model.add_loads(Torque(wall, 0 * N.z))
    model.form_eoms(LagrangesMethod)
    system = from_sympy(model, {"m": 1, "k": 4})
    law = Identity(
        "spring", Rate(real_symbol("qdot")) + real_symbol("k") * real_symbol("q") / real_symbol("m")
    )
    assert prove(system, law).decision == "proven"


def test_loads_need_an_inertial_frame():
    place = Point("P")
    place.set_vel(N, q.diff(t) * N.x)
    lagrangian = m * q.diff(t) ** 2 / 2
    method = LagrangesMethod(lagrangian, [q], forcelist=[(place, -k * q * N.x)])
    with pytest.raises(InputError, match="has loads but no inertial frame"):
        from_sympy(method, {"m": 1, "k": 4})
