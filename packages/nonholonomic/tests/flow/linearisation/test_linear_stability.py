"""Linear stability of steady motions."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import sympy as sp

from flowlanes import InputError
from flowlanes.flow.linearisation.linear_stability import linear_stability, relative_equilibrium
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import cross, real_symbol, vectors
from nonholonomic import from_catalogue

x, v, w, theta, c, s, g, length, k = (
    real_symbol(name) for name in ("x", "v", "w", "theta", "c", "s", "g", "l", "k")
)
gravity = Parameter(g, "gravity", 9.81, "m/s**2")
PENDULUM = System(
    name="pendulum",
    title="Pendulum on a trolley",
    field={x: v, theta: w, w: -g / length * sp.sin(theta), v: sp.S.Zero},
    parameters=(gravity, Parameter(length, "length", 0.5, "m")),
)
#: The same in the Cartesian coordinates s = sin θ, c = cos θ, with definitions in a row.
ROUND = System(
    name="round-pendulum",
    title="Pendulum on a circle",
    field={s: w * c, c: -w * s, w: -k * s},
    definitions={k: g / length},
    parameters=PENDULUM.parameters,
    relations=(s**2 + c**2 - 1,),
)
#: The free rigid body: a permanent rotation about each axis.
M, omega = vectors("M omega")
INERTIA = (real_symbol("I_1"), real_symbol("I_2"), real_symbol("I_3"))
TOP = System(
    name="free-body",
    title="Free rigid body",
    field={M: cross(M, omega)},
    definitions={omega: sp.ImmutableMatrix([m / i for m, i in zip(M, INERTIA, strict=True)])},
    parameters=tuple(Parameter(i, "moment", d) for i, d in zip(INERTIA, (1, 2, 4), strict=True)),
)


def numbers(found: tuple[object, ...], digits: int = 15) -> list[complex]:
    return [complex(mpmath.nstr(x.real, digits)) + 1j * float(x.imag) for x in found]


def test_a_hanging_pendulum_swings_with_the_frequency_of_the_books():
    found = linear_stability(PENDULUM, {"theta": 0, "w": 0})
    assert found.variables == (theta, w)
    frequency = mpmath.sqrt(mpmath.mpf("19.62"))
    with mpmath.workdps(30):
        frequency = mpmath.sqrt(mpmath.mpf("19.62"))
        assert abs(found.eigenvalues[0] - 1j * frequency) < mpmath.mpf("1e-28")
        assert abs(found.eigenvalues[1] + 1j * frequency) < mpmath.mpf("1e-28")
    assert not found.stable


def test_an_upright_pendulum_falls():
    found = linear_stability(PENDULUM, {"theta": sp.pi, "w": 0})
    assert found.eigenvalues[0].real == pytest.approx(19.62**0.5, rel=1e-14)
    assert found.eigenvalues[0].imag == 0
    mode = found.modes[0]
    assert float(mode[w] / mode[theta]) == pytest.approx(19.62**0.5, rel=1e-14)


def test_places_on_which_nothing_depends_are_left_out_one_after_the_other():
    found = linear_stability(PENDULUM, [3.0, 0.0, 0.0, 2.0])
    assert x not in found.variables
    assert v not in found.variables


def test_relations_leave_the_deviations_that_keep_to_them():
    found = linear_stability(ROUND, {"s": 0, "c": 1, "w": 0})
    assert found.basis.cols == 2
    assert numbers(found.eigenvalues) == pytest.approx([19.62**0.5 * 1j, -(19.62**0.5) * 1j])


def test_a_free_body_is_unstable_about_its_middle_axis():
    found = linear_stability(TOP, [0, "3/2", 0])
    # λ² = M² (1/I₁ − 1/I₂)(1/I₂ − 1/I₃)
    rate = 1.5 * (0.5 * 0.25) ** 0.5
    assert numbers(found.eigenvalues) == pytest.approx([rate, 0, -rate])


def test_directions_along_a_family_are_divided_out():
    found = linear_stability(TOP, [0, 0, 2], along=[{"M_3": 1}])
    assert found.basis.cols == 2
    assert {value.real for value in found.eigenvalues} == {0}


def test_a_direction_that_is_no_family_is_refused():
    with pytest.raises(InputError, match="does not lead along a family"):
        linear_stability(TOP, [0, 0, 2], along=[{"M_1": 1}])


def test_a_direction_that_leaves_the_phase_space_is_refused():
    still = System("still", "Still", field={s: 0 * s, c: s - s * c}, relations=(s**2 + c**2 - 1,))
    with pytest.raises(InputError, match="the relations do not annul it"):
        linear_stability(still, {"s": 0, "c": 1}, along=[{"c": 1}])


def test_a_relative_equilibrium_is_carried_along_by_a_symmetry():
    """A rolling disk: in its own axes the vertical turns all the time."""
    disk = from_catalogue("heavy-disk")
    still = {"M_1": 0, "M_2": 0, "gamma_2": 0, "gamma_3": 0, "gamma_1": 1}
    found = linear_stability(disk, {**still, "M_3": "4.5"})
    assert float(found.drift["rotation"]) == -3.0
    # uniform thin disk of radius 1 at angular velocity 3: λ² = 4g/5 − 12·9/5
    rate = (21.6 - 0.8 * 9.81) ** 0.5
    assert max(float(value.imag) for value in found.eigenvalues) == pytest.approx(rate, rel=1e-14)
    assert max(float(value.real) for value in found.eigenvalues) == 0


def test_a_slow_disk_falls():
    disk = from_catalogue("heavy-disk")
    still = {"M_1": 0, "M_2": 0, "gamma_2": 0, "gamma_3": 0, "gamma_1": 1}
    found = linear_stability(disk, {**still, "M_3": "1.5"})
    rate = (0.8 * 9.81 - 2.4) ** 0.5
    assert float(found.eigenvalues[0].real) == pytest.approx(rate, rel=1e-14)


def test_defective_eigenvalues_have_their_digits():
    """A Jordan block of size four: a chain of four cascaded filters."""
    chain = [real_symbol(f"y_{i}") for i in range(4)]
    system = System(
        name="cascade",
        title="Cascade",
        field={y: before - y for y, before in zip(chain, [sp.S.Zero, *chain], strict=False)},
    )
    found = linear_stability(system, dict.fromkeys(chain, 0), digits=20)
    with mpmath.workdps(30):
        assert all(abs(value + 1) < mpmath.mpf("1e-19") for value in found.eigenvalues)
    assert found.stable


def test_newton_finds_the_steady_motion_of_a_speed():
    """A conical pendulum: the slope belongs to its angular velocity."""
    tilt, rate, turn = real_symbol("tilt"), real_symbol("rate"), real_symbol("turn")
    cone = System(
        name="cone",
        title="Conical pendulum",
        field={
            tilt: rate,
            rate: turn**2 * sp.sin(tilt) * sp.cos(tilt) - g / length * sp.sin(tilt),
            turn: -2 * turn * rate / sp.tan(tilt),
        },
        parameters=PENDULUM.parameters,
    )
    state = relative_equilibrium(
        cone, {"tilt": 1.0, "rate": 0, "turn": 6}, fixed_variables=["turn"]
    )
    assert float(state[turn]) == 6
    assert float(mpmath.cos(state[tilt])) == pytest.approx(19.62 / 36, rel=1e-15)
    found = linear_stability(cone, state)
    frequency = 6 * (1 + 3 * (19.62 / 36) ** 2) ** 0.5
    assert max(float(value.imag) for value in found.eigenvalues) == pytest.approx(frequency)


def test_where_nothing_is_steady_newton_says_so():
    racing = System("racing", "Racing", field={v: v**2 + 1})
    with pytest.raises(InputError, match="no steady motion was found"):
        relative_equilibrium(racing, {"v": 0})


def test_something_must_be_left_to_be_found():
    with pytest.raises(InputError, match="all state variables are held"):
        relative_equilibrium(ROUND, {"s": 0, "c": 1, "w": 0}, fixed_variables=["s", "c", "w"])
    with pytest.raises(InputError, match="digits = 3"):
        relative_equilibrium(ROUND, {"s": 0, "c": 1, "w": 0}, digits=3)


def test_where_nothing_depends_on_the_state_there_is_nothing_to_linearise():
    falling = System("falling", "Free fall", field={x: v, v: -g}, parameters=(gravity,))
    with pytest.raises(InputError, match="nothing can be linearised"):
        linear_stability(falling, [0, 0])


@pytest.mark.parametrize(
    ("state", "message"),
    [
        ({"s": 0, "c": 1}, "gives no value for w"),
        ({"s": 0, "c": 1, "w": 1}, "not steady; s changes at the rate 1"),
        ({"s": 0, "c": 2, "w": 0}, "misses the phase space"),
        ({"s": 0, "c": 1, "q": 0}, "no state variable q; it has s, c, w"),
        ({"s": 0, "c": 1, "w": "much"}, "much"),
        ({"s": 0, "c": 1, "w": float("nan")}, "finite"),
        ({"s": 0, "c": 1, "w": 1j}, "real number"),
        ([0, 1], "has 2 numbers: 3 are needed"),
    ],
)
def test_mistakes_are_told_in_a_sentence(state: object, message: str):
    with pytest.raises(InputError, match=message):
        linear_stability(ROUND, state)


def test_unknown_parameters_and_too_few_digits_are_refused():
    with pytest.raises(InputError, match="no parameter mass; it has g, l"):
        linear_stability(ROUND, [0, 1, 0], {"mass": 1})
    with pytest.raises(InputError, match="digits = 2"):
        linear_stability(ROUND, [0, 1, 0], digits=2)


def test_a_state_is_given_by_components_vectors_or_velocity() -> None:
    ball = from_catalogue("chaplygin-ball")
    flat = linear_stability(ball, [0, 3, 0, 0, 1, 0]).matrix
    by_vectors = linear_stability(ball, {"M": (0, 3, 0), "gamma": np.array([0, 1, 0])})
    by_velocity = linear_stability(ball, {"omega": (0, 2, 0), "gamma": (0, 1, 0)})
    assert by_vectors.matrix == flat
    assert by_velocity.matrix == flat
    with pytest.raises(InputError, match=r"^M: must be 3 numbers, not \(0, 1\)$"):
        linear_stability(ball, {"M": (0, 1), "gamma": (0, 1, 0)})
