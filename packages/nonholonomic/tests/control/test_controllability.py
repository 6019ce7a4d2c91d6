"""Growth vectors of control fields against other computations, and proofs of controllability."""

from __future__ import annotations

import pytest
import sympy as sp
from flint import fmpq

from flowlanes.errors import InputError
from flowlanes.system.vectors import Vector
from nonholonomic.control import (
    Rotor,
    SphericalRobot,
    controllability,
    driftless_system,
    growth_vector,
    pendulum,
)
from nonholonomic.control.fields import GAMMA, RING, SQUARE, commutator, control_fields, minor
from nonholonomic.control.nonvanishing import Rectangle, vanishes_nowhere, without_real_zero
from nonholonomic.mechanics.constraints.growth import growth

x, y, z = GAMMA
E = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
SKEW = ((1, 1, 0), (0, 1, 2))


def robot(
    axes: tuple[tuple[int, ...], ...], contact: str = "marble", inertia: object = (0.4, 0.5, 0.6)
) -> SphericalRobot:
    return SphericalRobot(1.0, inertia, 1.0, tuple(Rotor(e, 0.1) for e in axes), contact)


def growth_on_configurations(ball: SphericalRobot, quaternion: tuple[int, ...]) -> tuple[int, ...]:
    """The growth of the fields in attitude and place, by the room of constraints."""
    system = driftless_system(ball).whole
    numbers = {p.symbol: sp.nsimplify(str(p.default)) for p in system.parameters}
    rates = [system.expand(rate).xreplace(numbers) for rate in system.rates[:6]]
    coordinates = system.symbols[:6]
    fields = [
        {q: sp.diff(rate, u) for q, rate in zip(coordinates, rates, strict=True)}
        for u in system.symbols[6:]
    ]
    length = sp.sqrt(sum(q**2 for q in quaternion))
    point = dict(
        zip(coordinates, [sp.Integer(q) / length for q in quaternion] + [0, 0], strict=True)
    )
    return growth(fields, coordinates, point)


@pytest.mark.parametrize(
    ("axes", "contact", "quaternion"),
    [
        (E[:1], "marble", (1, 1, 1, 1)),
        pytest.param(E[:2], "marble", (1, 1, 1, 1), marks=pytest.mark.slow),
        pytest.param(E[:2], "rubber", (1, 0, 0, 0), marks=pytest.mark.slow),
        pytest.param(E, "marble", (1, 1, 1, 1), marks=pytest.mark.slow),
        pytest.param(E[:2], "marble", (2, 4, 5, 2), marks=pytest.mark.slow),
        pytest.param(E[:2], "rubber", (1, 1, 1, 1), marks=pytest.mark.slow),
        pytest.param(SKEW, "rubber", (1, 1, 1, 1), marks=pytest.mark.slow),
        pytest.param(E, "rubber", (2, 4, 5, 2), marks=pytest.mark.slow),
    ],
)
def test_the_growth_is_that_in_attitude_and_place(
    axes: tuple[tuple[int, ...], ...], contact: str, quaternion: tuple[int, ...]
) -> None:
    w, a, b, c = quaternion
    vertical = (2 * (a * c - w * b), 2 * (b * c + w * a), w * w - a * a - b * b + c * c)
    ball = robot(axes, contact)
    assert growth_vector(ball, vertical) == growth_on_configurations(ball, quaternion)


def test_growth_vectors_known_by_hand() -> None:
    """Three rotors give every rolling motion: (3, 5), and (2, 3, 5) without spin; one a curve."""
    for vertical in ((0, 0, 1), (1, 2, -3), (1, 0, 0)):
        assert growth_vector(robot(E), vertical) == (3, 5)
        assert growth_vector(robot(E, "rubber"), vertical) == (2, 3, 5)
        assert growth_vector(robot(E[:1]), vertical) == (1,)
    # two rotors e1, e2 without spin: where γ_3 = 0 speeds with Ku ∥ γ do not turn the ball
    assert growth_vector(robot(E[:2], "rubber"), (3, 4, 0))[0] == 1
    assert growth_vector(robot(E[:2], "rubber"), (3, 4, 1e-9))[0] == 2


@pytest.mark.parametrize("inertia", [(0.4, 0.4, 0.4), (0.4, 0.5, 0.6), (0.5, 0.5, 0.7)])
def test_two_rotors_of_a_marble_bring_it_anywhere(inertia: tuple[float, ...]) -> None:
    verdict = controllability(robot(E[:2], inertia=inertia))
    assert (verdict.decision, verdict.proven, verdict.growth) == ("controllable", True, (2, 3, 5))
    assert verdict.exceptional == (Vector("gamma").symbols[2],)
    assert verdict.growth_there == ((2, 3, 4, 5),)
    assert verdict.steps == 4


@pytest.mark.slow
@pytest.mark.parametrize("axes", [E[:2], SKEW])
def test_two_rotors_of_a_rubber_ball_bring_it_anywhere(axes: tuple[tuple[int, ...], ...]) -> None:
    verdict = controllability(robot(axes, "rubber"))
    assert verdict.decision == "controllable" and verdict.growth == (2, 3, 5)
    normal = sp.Matrix(axes[0]).cross(sp.Matrix(axes[1]))
    plane = normal.dot(sp.Matrix(Vector("gamma").symbols))
    assert len(verdict.exceptional) == 1
    assert sp.simplify(verdict.exceptional[0] / plane).is_number
    assert verdict.growth_there == ((1, 2, 3, 4, 5),)


@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_three_rotors_and_one(contact: str) -> None:
    verdict = controllability(robot(E, contact))
    assert verdict.decision == "controllable" and verdict.exceptional == ()
    one = controllability(robot(((1, 2, 3),), contact))
    assert (one.decision, one.growth) == ("not controllable", (1,))
    assert "fill a curve" in str(one)


def test_a_full_tensor_turned_with_its_rotors_has_the_same_growth() -> None:
    # principal axes turned by (2, 4, 5, 2)/7 (a rational rotation)
    w, a, b, c = (sp.Rational(k, 7) for k in (2, 4, 5, 2))
    turn = sp.Matrix(
        [
            [1 - 2 * (b * b + c * c), 2 * (a * b - w * c), 2 * (a * c + w * b)],
            [2 * (a * b + w * c), 1 - 2 * (a * a + c * c), 2 * (b * c - w * a)],
            [2 * (a * c - w * b), 2 * (b * c + w * a), 1 - 2 * (a * a + b * b)],
        ]
    )
    inertia = turn * sp.diag(0.4, 0.5, 0.6) * turn.T
    tensor = tuple(tuple(float(v) for v in inertia.row(i)) for i in range(3))
    axes = tuple(tuple(int(49 * v) for v in turn.col(i)) for i in range(2))
    ball = SphericalRobot(1.0, tensor, 1.0, tuple(Rotor(e, 0.1) for e in axes))
    assert growth_vector(ball, tuple(int(49 * v) for v in turn.col(2))) == (2, 3, 5)


def test_commutators_satisfy_jacobi_and_are_skew() -> None:
    (_, g1), (_, g2), (_, g3) = control_fields(robot(E)).levels[0]
    total = [
        p + q + r
        for p, q, r in zip(
            commutator(g1, commutator(g2, g3)),
            commutator(g2, commutator(g3, g1)),
            commutator(g3, commutator(g1, g2)),
            strict=True,
        )
    ]
    assert all(divmod(entry, SQUARE - 1)[1] == 0 for entry in total)
    assert all(p == -q for p, q in zip(commutator(g1, g2), commutator(g2, g1), strict=True))
    assert any(entry != 0 for entry in commutator(g1, g2))


def test_the_determinant_of_two_rotors_in_a_homogeneous_ball() -> None:
    """It is γ₃ times two definite forms, for I = 2/5, D = 1; found by Gröbner bases apart."""
    fields = control_fields(robot(E[:2], inertia=(0.4, 0.4, 0.4)))
    longer = fields.with_next_commutators().with_next_commutators()
    value = minor([field for level in longer.levels for _, field in level])
    expected = z * (25 * z**2 - 63) * (25 * z**2 + 203)
    ratio, remainder = divmod(value, expected)
    assert remainder == 0 and ratio.total_degree() == 0 and ratio != 0


def test_forms_without_real_zeros() -> None:
    one, two = RING.constant(1), fmpq(1, 2)
    assert without_real_zero(SQUARE) is True
    assert without_real_zero(x**2 + y**2 - z**2) is False
    assert without_real_zero(x) is False
    assert without_real_zero(SQUARE**2 - 3 * x**2 * y**2) is True
    # 4 x²y² ≤ |γ|⁴ with equality at z = 0, x = ±y: a zero without change of sign
    assert without_real_zero(SQUARE**2 - 4 * x**2 * y**2, depth=6) is not True
    corner = Rectangle(2, (two, two), (fmpq(1), fmpq(1)))
    assert vanishes_nowhere(x * y - z**2 * fmpq(1, 5), corner)
    assert not vanishes_nowhere(x * y - z**2 * two, corner)
    assert vanishes_nowhere(one, corner)


@pytest.mark.parametrize("function", [controllability, lambda r: growth_vector(r, (0, 0, 1))])
def test_drift_is_refused(function: object) -> None:
    ball = SphericalRobot(1.0, (0.4, 0.4, 0.4), 1.0, moving_mass=pendulum(1.0, 0.5))
    with pytest.raises(InputError, match="has a drift"):
        function(ball)  # type: ignore[operator]
    with pytest.raises(InputError, match="three numbers, not all zero"):
        growth_vector(robot(E), (0, 0, 0))
