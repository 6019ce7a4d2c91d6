"""The turn about the one direction that stays in space."""

from __future__ import annotations

from dataclasses import replace

import flint
import mpmath
import numpy as np
import pytest
import sympy as sp

from flowlanes.flow.integrator import integrate
from flowlanes.system.vectors import real_symbol, to_components, vectors
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two.attitude_one_axis import (
    Reference,
    farthest_from_axis,
    rate,
    references,
    rotated_triad,
    spin_identity,
    spin_rate,
)
from nonholonomic.closed_form.genus_two.separation import nu, nuprime
from nonholonomic.closed_form.separations.ball_sphere import hollow_ball
from nonholonomic.closed_form.separations.bruns import veselova_in_bruns_field

BALL, BRUNS = hollow_ball(), veselova_in_bruns_field()
AXES = {f"{of.name} {i}": (of, references(of)[i]) for of in (BALL, BRUNS) for i in (1, 2, 3)}


@pytest.mark.slow
@pytest.mark.parametrize("name", AXES)
def test_the_rate_about_a_body_axis_is_proven(name):
    of, reference = AXES[name]
    assert prove(of.system, spin_identity(of, reference)).decision == "proven"


@pytest.mark.slow
def test_the_rate_by_the_normal_is_proven():
    assert prove(BALL.system, spin_identity(BALL, references(BALL)[0])).decision == "proven"


@pytest.mark.slow
def test_a_wrong_velocity_is_refuted():
    law = spin_identity(BALL, Reference(nu, nuprime / BALL.time_rescaling))
    assert prove(BALL.system, law).decision == "refuted"


@pytest.mark.slow
def test_a_vector_that_moves_is_refuted():
    law = spin_identity(replace(BALL, fixed=(BALL.direction,)), references(BALL)[1])
    assert prove(BALL.system, law).decision == "refuted"


#: A body, and a start with (AM, γ) = 0.
PARAMETERS = {"m": "1", "R": "1", "a": "0.5", "I_1": "1.5", "I_2": "1", "I_3": "2.1"}
NORMAL = ("0.48", "-0.64", "0.6")
LEVER = ("1.3", "1.8", "0.7")


def triad(fixed, reference):
    """The direction of κ, that of the part of e across it, and their vector product."""
    one = [x / sum(y * y for y in fixed).sqrt() for x in fixed]
    share = sum(x * y for x, y in zip(reference, one, strict=True))
    across = [x - share * y for x, y in zip(reference, one, strict=True)]
    two = [x / sum(y * y for y in across).sqrt() for x in across]
    return one, two, [one[i - 2] * two[i - 1] - one[i - 1] * two[i - 2] for i in range(3)]


def matrix(w, x, y, z):
    """Body to space, of a unit quaternion."""
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


def test_the_attitude_of_a_motion():
    psi = real_symbol("psi")
    system = BALL.system
    known = {nu: BALL.direction, nuprime: BALL.turning}
    formula = spin_rate(BALL, references(BALL)[0]).subs(
        [
            pair
            for name, value in known.items()
            for pair in zip(name.symbols, to_components(value), strict=True)
        ]
    )
    lifted = replace(system.lifted(), observables=())
    measured = replace(lifted, field=(*lifted.field, (psi, formula)))
    with mpmath.workdps(34):
        a, b, c = (mpmath.mpf(x) * mpmath.mpf(y) for x, y in zip(LEVER, NORMAL, strict=True))
        M = mpmath.mpf("0.9"), mpmath.mpf("-0.7")
        start = (*M, -(a * M[0] + b * M[1]) / c, *map(mpmath.mpf, NORMAL), 0.5, 0.5, -0.5, 0.5, 0)
        motion = integrate(
            measured,
            [mpmath.nstr(mpmath.mpf(x), 36) for x in start],
            (0, 3, 8),
            parameters=PARAMETERS,
            precision="quad",
        )
        rows = [[mpmath.mpf(str(x)) for x in row] for row in motion.states]
    with flint.ctx.workdps(40):
        states = [[flint.arb(mpmath.nstr(x, 36)) for x in row] for row in rows]
        body = triad(states[0][:3], states[0][3:6])
        space = [
            [
                sum((m * v for m, v in zip(row, vector, strict=True)), flint.arb(0))
                for row in matrix(*states[0][6:10])
            ]
            for vector in body
        ]
        for state in states:
            angle = state[10]
            axes = rotated_triad(space, angle.cos(), angle.sin())
            body = triad(state[:3], state[3:6])
            for i, row in enumerate(matrix(*state[6:10])):
                for j, entry in enumerate(row):
                    assert abs(sum(axes[k][i] * body[k][j] for k in range(3)) - entry) < 1e-27


def test_arrays_and_formulas_give_the_same():
    generator = np.random.default_rng(7)
    fixed, e, w = generator.normal(size=(3, 3, 5))
    fixed /= np.linalg.norm(fixed, axis=0)
    names = [vectors(name)[0].symbols for name in ("kappa", "e", "w")]
    formula = sp.lambdify([s for name in names for s in name], rate(*names))
    assert np.allclose(rate(fixed, e, w), formula(*fixed, *e, *w), rtol=1e-13)


def test_the_farthest_reference():
    angles = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    circle = 3 * np.array([np.cos(angles), np.sin(angles), 0 * angles])
    axes = [np.eye(3)[:, [i]] for i in range(3)]
    assert farthest_from_axis(circle, axes) == 2
    across = np.array([-np.sin(angles), np.cos(angles), 0.1 + 0 * angles])
    assert farthest_from_axis(circle + np.array([[0], [0], [5]]), [*axes[:2], across]) == 2


def test_no_reference_is_needed_beside_the_normal():
    """(AM, n) = 0 with A > 0 keeps n away from ±M, by Kantorovich's inequality."""
    generator = np.random.default_rng(3)
    A = np.array([1.8, 1.3, 0.7])
    n = generator.normal(size=(3, 2000))
    n /= np.linalg.norm(n, axis=0)
    M = np.cross(A[:, None] * n, generator.normal(size=(3, 2000)), axis=0)
    M /= np.linalg.norm(M, axis=0)
    sine = np.sqrt(1 - np.sum(M * n, axis=0) ** 2)
    assert sine.min() >= 2 * np.sqrt(A.max() * A.min()) / (A.max() + A.min()) - 1e-12
