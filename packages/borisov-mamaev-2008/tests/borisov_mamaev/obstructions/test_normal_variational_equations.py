"""§9.4 by numbers: the monodromy of the variations across a great circle, along paths in t."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from borisov_mamaev_2008.obstructions.normal_variational_equations import no_second_integral

FIRST, SECOND = 2.0, 3.1


def monodromy(centre, third, base=0.0):
    """Of (1 + t²)² (P y_t)_t + (3P − 2J₃(1 + t²)) y = 0, P = J₁ + J₂t², once around a point.

    The path goes from `base` along the imaginary axis to a circle, around it and back.
    """
    radius = 0.05
    edge = centre - 1j * radius
    paths = [
        (lambda s: base + s * (edge - base), lambda s: edge - base),
        (
            lambda s: centre - 1j * radius * np.exp(2j * np.pi * s),
            lambda s: 2 * np.pi * radius * np.exp(2j * np.pi * s),
        ),
        (lambda s: edge + s * (base - edge), lambda s: base - edge),
    ]
    total = np.eye(2, dtype=complex)
    for place, speed in paths:

        def rate(s, state, place=place, speed=speed):
            t = place(s)
            weight = FIRST + SECOND * t**2
            y, flux = state.reshape(2, 2)
            force = -(3 * weight - 2 * third * (1 + t**2)) / (1 + t**2) ** 2 * y
            return speed(s) * np.concatenate([flux / weight, force])

        start = total.reshape(-1)
        total = solve_ivp(rate, (0, 1), start, "DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
        total = total.reshape(2, 2)
    return total


ROOT, POLE = 1j * np.sqrt(FIRST / SECOND), 1j


def test_the_monodromy_around_a_root_is_unipotent():
    turned = monodromy(ROOT, 2.6)
    assert np.trace(turned) == pytest.approx(2, abs=1e-8)
    assert np.linalg.det(turned) == pytest.approx(1, abs=1e-8)
    assert np.linalg.norm(turned - np.eye(2)) > 0.1


def test_the_exponents_at_i_are_half_integers():
    turned = monodromy(POLE, 2.6, base=0.3)
    assert np.trace(turned) == pytest.approx(-2, abs=1e-8)


@pytest.mark.parametrize(("third", "reducible"), [(2.6, False), (4.0, False), (FIRST, True)])
def test_there_is_an_invariant_line_for_equal_eigenvalues_alone(third, reducible):
    """Two matrices have a common eigenvector if and only if their commutator has the trace 2."""
    first = monodromy(ROOT, third, base=0.3)
    second = monodromy(POLE, third, base=0.3)
    whole = first @ second @ np.linalg.inv(first) @ np.linalg.inv(second)
    assert (abs(np.trace(whole) - 2) < 1e-6) == reducible


@pytest.mark.slow
def test_the_verdict():
    assert no_second_integral().decision == "proven"
