"""§12: enough independent integrals for the theorem of Euler and Jacobi."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from catalogue import built
from flowlanes.system.vectors import to_components


@pytest.mark.parametrize(
    ("name", "cyclic"), [("ball-bearing", 0), ("straight-line-ball", 1), ("disk-on-ice", 0)]
)
def test_integrals_leave_two_dimensions(name: str, cyclic: int) -> None:
    """Relations and integrals are independent; the place along the line is a cyclic variable."""
    made = built.example(name)
    system = made.system
    state = list(system.symbols)
    functions = [to_components(law.value) for law in system.integrals]
    functions += [to_components(relation) for relation in system.relations]
    numbers = {**system.defaults, **dict(zip(state, map(float, made.start), strict=False))}
    flat = {}
    for symbol, value in system.scalar_definitions:
        flat[symbol] = value.xreplace(flat)
    slopes = [
        [float(sp.diff(f.xreplace(flat), s).xreplace(numbers)) for s in state] for f in functions
    ]
    independent = int(np.linalg.matrix_rank(np.array(slopes), tol=1e-9))
    assert independent == len(functions)
    assert len(state) - independent - cyclic == 2


MOMENTS = np.array([1.0, 1.5, 2.1])
LEVER = 0.8


def momentum(angles, rates, area, rotors):
    """M of the ball from θ, φ and their rates, with ψ̇ from (M + k, γ) = c."""
    theta, phi = angles
    gamma = np.array([np.sin(theta) * np.sin(phi), np.sin(theta) * np.cos(phi), np.cos(theta)])
    nodes = np.array([np.cos(phi), -np.sin(phi), 0.0])

    def turning(psidot):
        return psidot * gamma + rates[0] * nodes + rates[1] * np.array([0.0, 0.0, 1.0])

    def made(psidot):
        omega = turning(psidot)
        return MOMENTS * omega + LEVER * (omega - (gamma @ omega) * gamma)

    # (M, γ) is affine in ψ̇
    at_rest = (made(0.0) + rotors) @ gamma
    slope = (made(1.0) + rotors) @ gamma - at_rest
    return made((area - at_rest) / slope)


def odd_part(area, rotors):
    """The part of (M + k)² that changes its sign with the rates."""
    angles, rates = (0.9, 0.4), np.array([0.7, -0.3])
    there, back = (momentum(angles, sign * rates, area, rotors) + rotors for sign in (1, -1))
    return (there @ there - back @ back) / 2


def test_linear_terms_of_the_quadratic_integral_vanish_with_the_area() -> None:
    still, rotors = np.zeros(3), np.array([0.2, -0.1, 0.3])
    assert abs(odd_part(0.6, still)) > 1e-3
    assert abs(odd_part(0.0, still)) < 1e-12
    assert abs(odd_part(0.6, rotors)) > 1e-3
