"""Kane models of SymPy taken in: equations, constraints, reactions, and clear sentences."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    System as SympySystem,
    dynamicsymbols,
    inertia,
)

from flowlanes import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol
from lawproof import prove
from nonholonomic.mechanics.constraints.integrability import nonholonomy
from nonholonomic.mechanics.lagrangian.mechanism import TIME
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.mechanics.sympy_models.conversion import from_sympy, mechanism_from_sympy

N = ReferenceFrame("N")
t = dynamicsymbols._t
m, g, length, k = sp.symbols("m g l k", positive=True)
q, u = dynamicsymbols("q u")


def pendulum(speeds: bool = True) -> KanesMethod:
    """A mathematical pendulum in the angle q, with damping."""
    rod = N.orientnew("A", "Axis", [q, N.z])
    rod.set_ang_vel(N, u * N.z)
    origin, end = Point("O"), Point("P")
    origin.set_vel(N, 0)
    end.set_pos(origin, length * rod.x)
    end.v2pt_theory(origin, N, rod)
    bob = Particle("B", end, m)
    loads = [(end, m * g * N.x), (rod, -k * u * N.z)]
    kinematics = [q.diff(t) - u] if speeds else None
    return KanesMethod(N, q_ind=[q], u_ind=[u], kd_eqs=kinematics, bodies=[bob], forcelist=loads)


NUMBERS = {"m": 2.0, "g": 9.81, "l": 0.5, "k": 0.1}


def test_a_pendulum_by_kanes_method():
    system = from_sympy(pendulum(), NUMBERS, name="pendulum", title="Pendulum")
    angle, speed = real_symbol("q"), real_symbol("u")
    assert system.symbols == (angle, speed)
    assert {str(p.symbol): p.default for p in system.parameters} == NUMBERS
    m_, g_, l_, k_ = (real_symbol(name) for name in NUMBERS)
    right = -g_ / l_ * sp.sin(angle) - k_ * speed / (m_ * l_**2)
    law = Identity("equation", (Rate(angle) - speed, Rate(speed) - right))
    assert prove(system, law).decision == "proven"
    positive = {p.symbol: p.admissible for p in system.parameters}
    assert positive[m_] == (m_ > 0,)


def test_the_model_is_left_as_it_is():
    method = pendulum()
    from_sympy(method, NUMBERS)
    with pytest.raises(ValueError, match="Fr"):
        method.mass_matrix  # noqa: B018  (its equations are still not formed)


def test_a_pendulum_runs():
    system = from_sympy(pendulum(), {**NUMBERS, "k": 0.0})
    run = integrate(system, [0.3, 0.0], [0.0, 1.0, 2.0])
    kinetic = run.records["kinetic_energy"]
    height = [float(sp.cos(x)) for x in run.states[:, 0]]
    total = [float(e) - 9.81 * h for e, h in zip(kinetic, height, strict=True)]
    assert total == pytest.approx([total[0]] * 3, rel=1e-14)


def test_auxiliary_speeds_bring_out_reactions():
    """The pull on the pivot of a pendulum, along and across the rod."""
    u2, u3, along, across = dynamicsymbols("u2 u3 along across")
    rod = N.orientnew("A", "Axis", [q, N.z])
    rod.set_ang_vel(N, u * N.z)
    pivot, end = Point("O"), Point("P")
    pivot.set_vel(N, u2 * rod.x + u3 * rod.y)
    end.set_pos(pivot, length * rod.x)
    end.v2pt_theory(pivot, N, rod)
    method = KanesMethod(
        N,
        q_ind=[q],
        u_ind=[u],
        u_auxiliary=[u2, u3],
        kd_eqs=[q.diff(t) - u],
        bodies=[Particle("B", end, m)],
        forcelist=[(end, m * g * N.x), (pivot, along * rod.x + across * rod.y)],
    )
    system = from_sympy(method, {"m": 2, "g": 9.81, "l": 0.5})
    shown = {o.name: o.value for o in system.observables}
    m_, g_, l_, q_, u_ = (real_symbol(name) for name in ("m", "g", "l", "q", "u"))
    pull = Identity("along", shown["along"] + m_ * (g_ * sp.cos(q_) + l_ * u_**2))
    assert prove(system, pull).decision == "proven"
    # the bob is free to move across: the pivot feels nothing
    assert prove(system, Identity("across", shown["across"])).decision == "proven"


def on_a_rail(constraint: sp.Expr, *forces: tuple[Point, sp.Expr]) -> KanesMethod:
    """A particle on a blade, carried by a rail that an auxiliary speed moves."""
    x, y, u1, u2, u3, hold = dynamicsymbols("x y u1 u2 u3 hold")
    rail, place = Point("R"), Point("P")
    rail.set_vel(N, u3 * N.y)
    place.set_vel(N, u1 * N.x + (u2 + u3) * N.y)
    return KanesMethod(
        N,
        q_ind=[x, y],
        u_ind=[u1],
        u_dependent=[u2],
        u_auxiliary=[u3],
        velocity_constraints=[constraint],
        kd_eqs=[x.diff(t) - u1, y.diff(t) - u2],
        bodies=[Particle("B", place, m)],
        forcelist=[(rail, hold * N.y), *forces],
    )


def test_auxiliary_speeds_beside_velocity_constraints_bring_out_reactions():
    """The ice holds the blade, so the rail holds nothing; a blade on the rail it holds in turn."""
    x, u1, u2, u3 = dynamicsymbols("x u1 u2 u3")
    x_, u1_, m_ = (real_symbol(name) for name in ("x", "u1", "m"))
    across = real_symbol("u2")
    for constraint, held in ((u2 + u3 - x * u1, 0), (u2 - x * u1, m_ * Rate(across))):
        system = from_sympy(on_a_rail(constraint), {"m": 2})
        shown = {o.name: o.value for o in system.observables}
        law = Identity("held", shown["hold"] - held)
        assert prove(system, law).decision == "proven"
        assert prove(system, Identity("slope", across - x_ * u1_)).decision == "proven"
        wrong = Identity("wrong", shown["hold"] - m_)
        assert prove(system, wrong).decision == "refuted"


def test_auxiliary_speeds_that_determine_no_force_are_refused():
    x, u1, u2 = dynamicsymbols("x u1 u2")
    end, more = Point("E"), dynamicsymbols("more")
    end.set_vel(N, dynamicsymbols("u3") * N.y)
    model = on_a_rail(u2 - x * u1, (end, more * N.y))
    with pytest.raises(InputError, match="1 auxiliary speed should bring out as many"):
        from_sympy(model, {"m": 2})
    with pytest.raises(InputError, match="bring out hold, which a mechanism does not record"):
        mechanism_from_sympy(on_a_rail(u2 - x * u1), {"m": 2})


def constrained() -> KanesMethod:
    """A particle in the Cartesian coordinates of a plane on a rod: one constraint of each kind."""
    x, y, u1, u2 = dynamicsymbols("x y u1 u2")
    place = Point("P")
    place.set_vel(N, u1 * N.x + u2 * N.y)
    bob = Particle("B", place, m)
    circle = x**2 + y**2 - length**2
    return KanesMethod(
        N,
        q_ind=[x],
        q_dependent=[y],
        configuration_constraints=[circle],
        u_ind=[u1],
        u_dependent=[u2],
        velocity_constraints=[x * u1 + y * u2],
        kd_eqs=[x.diff(t) - u1, y.diff(t) - u2],
        bodies=[bob],
        forcelist=[(place, -m * g * N.y)],
    )


def test_constraints_become_relations_and_multipliers_observables():
    system = from_sympy(constrained(), {"m": 2, "g": 9.81, "l": 0.5})
    x, y, u1, u2 = system.symbols
    assert len(system.relations) == 2
    m_, g_, _ = (real_symbol(name) for name in "mgl")
    tension = m_ * (-(u1**2) - u2**2 + g_ * y) / (x**2 + y**2)
    law = Identity("equation", (Rate(u1) - tension * x / m_, Rate(x) - u1))
    assert prove(system, law).decision == "proven"
    shown = {o.name: o for o in system.observables}
    value_of = Identity("tension", shown["lambda_1"].value - tension)
    assert prove(system, value_of).decision == "proven"


def test_massless_speeds_are_allowed_where_a_constraint_moves_them():
    """A wheel without mass of its own, whose turning follows from a constraint."""
    x, phi, u1, u2 = dynamicsymbols("x phi u1 u2")
    place = Point("P")
    place.set_vel(N, u1 * N.x)
    method = KanesMethod(
        N,
        q_ind=[x],
        q_dependent=[phi],
        configuration_constraints=[x - length * phi],
        u_ind=[u1],
        u_dependent=[u2],
        velocity_constraints=[u1 - length * u2],
        kd_eqs=[x.diff(t) - u1, phi.diff(t) - u2],
        bodies=[Particle("B", place, m)],
        forcelist=[(place, -k * x * N.x)],
    )
    system = from_sympy(method, {"m": 2, "k": 3, "l": 0.5})
    u1_, x_ = real_symbol("u1"), real_symbol("x")
    law = Identity("equation", Rate(u1_) + real_symbol("k") * x_ / real_symbol("m"))
    assert prove(system, law).decision == "proven"


def test_a_driven_angle_is_an_input():
    drive = dynamicsymbols("T")
    method = pendulum()
    method._forcelist = [*method.loads, (method.bodies[0].point, drive * N.y)]
    with pytest.raises(InputError, match=r"T\(t\) depends on the time"):
        from_sympy(method, NUMBERS)
    force = 3 * sp.sin(2 * t)
    system = from_sympy(method, NUMBERS, inputs={"T": force})
    assert TIME in system.symbols
    law = Identity("clock", Rate(TIME) - 1)
    assert prove(system, law).decision == "proven"


def wheel_on_a_rail() -> KanesMethod:
    """A wheel that rolls along a rail, pulled by its weight."""
    x, phi, u1, u2 = dynamicsymbols("x phi u1 u2")
    wheel = N.orientnew("W", "Axis", [phi, N.y])
    wheel.set_ang_vel(N, u2 * N.y)
    centre = Point("C")
    centre.set_vel(N, u1 * N.x)
    body = RigidBody("W", centre, wheel, m, (inertia(wheel, 0, k, 0), centre))
    return KanesMethod(
        N,
        q_ind=[x, phi],
        u_ind=[u1],
        u_dependent=[u2],
        velocity_constraints=[u1 - length * u2],
        kd_eqs=[x.diff(t) - u1, phi.diff(t) - u2],
        bodies=[body],
        forcelist=[(centre, m * g * N.x)],
    )


def test_kanes_models_become_mechanisms_that_are_told_their_nonholonomy():
    mechanism = mechanism_from_sympy(wheel_on_a_rail(), {"m": 1, "g": 9, "k": 1, "l": 1})
    assert nonholonomy(mechanism).verdict == "holonomic"
    one = equations_of_motion(mechanism)
    u2 = real_symbol("u2")
    right = (
        real_symbol("m")
        * real_symbol("g")
        * real_symbol("l")
        / (real_symbol("k") + real_symbol("m") * real_symbol("l") ** 2)
    )
    symbol = u2 if u2 in one.symbols else real_symbol("u1") / real_symbol("l")
    assert prove(one, Identity("rolling down", Rate(symbol) - right)).decision == "proven"


def test_constraints_built_into_velocities_are_seen():
    """A point at rest in the velocities: Kane's equations are right, Lagrange's would be wrong."""
    q1, q2, q3, u1, u2, u3 = dynamicsymbols("q1 q2 q3 u1 u2 u3")
    heading = N.orientnew("Y", "Axis", [q1, N.z])
    leaning = heading.orientnew("L", "Axis", [q2, heading.x])
    disc = leaning.orientnew("R", "Axis", [q3, leaning.y])
    contact = Point("C")
    contact.set_vel(N, 0)
    centre = contact.locatenew("D", length * leaning.z)
    centre.v2pt_theory(contact, N, disc)
    body = RigidBody("D", centre, disc, m, (inertia(leaning, k, 2 * k, k), centre))
    pairs = ((q1, u1), (q2, u2), (q3, u3))
    method = KanesMethod(
        N,
        q_ind=[q1, q2, q3],
        u_ind=[u1, u2, u3],
        kd_eqs=[a.diff(t) - b for a, b in pairs],
        bodies=[body],
        forcelist=[(centre, -m * g * N.z)],
    )
    with pytest.raises(InputError, match="built into the velocities"):
        mechanism_from_sympy(method, {"m": 1, "g": 9.81, "l": 1, "k": 0.25})


def test_fewer_coordinates_than_speeds_make_no_mechanism():
    spin, u1, u2 = dynamicsymbols("s u1 u2")
    place = Point("P")
    place.set_vel(N, u1 * N.x + u2 * N.y)
    method = KanesMethod(
        N,
        q_ind=[spin],
        u_ind=[u1, u2],
        kd_eqs=[spin.diff(t) - u1],
        bodies=[Particle("B", place, m)],
        forcelist=[(place, -m * g * N.y)],
    )
    assert len(from_sympy(method, {"m": 1, "g": 9.81}).symbols) == 3
    with pytest.raises(InputError, match="2 speeds for 1 coordinates"):
        mechanism_from_sympy(method, {"m": 1, "g": 9.81})


# --- mistakes --------------------------------------------------------------------------------


def test_constants_need_defaults_of_their_own():
    with pytest.raises(InputError, match="give a default for every constant; k, l has none"):
        from_sympy(pendulum(), {"m": 1, "g": 9.81})
    with pytest.raises(InputError, match="no constant R; it has g, k, l, m"):
        from_sympy(pendulum(), {**NUMBERS, "R": 1})
    with pytest.raises(InputError, match="g = heavy is not a number"):
        from_sympy(pendulum(), {**NUMBERS, "g": "heavy"})
    with pytest.raises(InputError, match="m is given as M"):
        from_sympy(pendulum(), {**NUMBERS, "m": Parameter(real_symbol("M"), "mass", 1.0)})


def test_inputs_must_be_inputs_of_the_model():
    with pytest.raises(InputError, match="the model has no input T; it has none"):
        from_sympy(pendulum(), NUMBERS, inputs={"T": 1})


def test_unfinished_models_are_told_so():
    bare = KanesMethod(N, q_ind=[q], u_ind=[u], kd_eqs=[q.diff(t) - u])
    with pytest.raises(InputError, match="has no bodies"):
        from_sympy(bare, {})
    with pytest.raises(InputError, match="no kinematic differential equations"):
        from_sympy(pendulum(speeds=False), NUMBERS)
    with pytest.raises(InputError, match="the System object has no bodies"):
        from_sympy(SympySystem(), {})


def test_other_objects_are_refused():
    with pytest.raises(InputError, match="list is no model that can be taken in; allowed: Kanes"):
        from_sympy([], {})


def test_a_speed_that_moves_nothing_is_refused():
    x, y, u1, u2 = dynamicsymbols("x y u1 u2")
    place = Point("P")
    place.set_vel(N, u1 * N.x)
    method = KanesMethod(
        N,
        q_ind=[x, y],
        u_ind=[u1, u2],
        kd_eqs=[x.diff(t) - u1, y.diff(t) - u2],
        bodies=[Particle("B", place, m)],
        forcelist=[(place, -m * g * N.x)],
    )
    with pytest.raises(InputError, match="mass matrix is singular"):
        from_sympy(method, {"m": 1, "g": 9.81})


def test_constraints_that_depend_on_each_other_are_refused():
    x, y, z, u1, u2, u3 = dynamicsymbols("x y z u1 u2 u3")
    place = Point("P")
    place.set_vel(N, u1 * N.x + u2 * N.y + u3 * N.z)
    slip = [u2 - x * u1 + u3, 2 * u2 - 2 * x * u1 + 2 * u3]
    method = KanesMethod(
        N,
        q_ind=[x, y, z],
        u_ind=[u1],
        u_dependent=[u2, u3],
        velocity_constraints=slip,
        kd_eqs=[x.diff(t) - u1, y.diff(t) - u2, z.diff(t) - u3],
        bodies=[Particle("B", place, m)],
        forcelist=[(place, -m * g * N.y)],
        constraint_solver=lambda a, b: b,
    )
    with pytest.raises(InputError, match="depend on each other"):
        from_sympy(method, {"m": 1, "g": 9.81})
