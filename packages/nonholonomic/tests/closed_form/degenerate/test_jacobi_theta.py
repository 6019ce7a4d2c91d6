"""Theta functions in balls and in arrays against mpmath."""

import mpmath
import numpy as np
import pytest
from flint import acb, arb, ctx

from nonholonomic.closed_form.degenerate.jacobi_theta import Thetas

DIGITS = 45


def reference(index: int, z: complex, y: str, derivative: int) -> mpmath.mpc:
    with mpmath.workdps(DIGITS + 10):
        factor = mpmath.sqrt(mpmath.mpf(y)) if mpmath.mpf(y) < 1 else 1
        nome = mpmath.exp(-mpmath.pi * mpmath.mpf(y))
        return factor * mpmath.jtheta(index, mpmath.mpmathify(z), nome, derivative)


@pytest.mark.parametrize("y", ["0.2", "0.9", "1.1", "4"])
@pytest.mark.parametrize("index", [1, 2, 3, 4])
def test_values_and_derivatives(index: int, y: str) -> None:
    for z in (0.375, 2.75, -9.125):
        with ctx.workprec(180):
            found = Thetas(arb(y)).pair(index, arb(z))
        arrays = Thetas(arb(y)).pair(index, np.array([z]))
        for derivative in (0, 1):
            wanted = mpmath.nstr(reference(index, z, y, derivative).real, DIGITS)
            with ctx.workprec(180):
                assert abs(found[derivative] - arb(wanted)) < 1e-40
            assert arrays[derivative][0] == pytest.approx(float(wanted), abs=2e-14)


@pytest.mark.parametrize("y", ["0.3", "1.5"])
@pytest.mark.parametrize("index", [1, 2, 3, 4])
def test_complex_balls_contain_the_value(index: int, y: str) -> None:
    z = 0.5 + 0.375j
    wanted = reference(index, z, y, 0)
    with ctx.workprec(100):
        wide = acb(arb(z.real, 0.01), arb(z.imag, 0.01))
        found = Thetas(arb(y)).value(index, wide)
    assert found.contains(acb(float(wanted.real), float(wanted.imag)))
    assert found.rad() < 1
