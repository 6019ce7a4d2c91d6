"""What the constraints of a mechanism tell of its plan."""

import numpy as np
import pytest
import sympy as sp

from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol
from nonholonomic.mechanics.lagrangian.mechanism import Frame, Mechanism, coordinates
from nonholonomic.mechanics.lagrangian.plan import plan_of

x, y, z, phi, psi, l = (real_symbol(name) for name in ("x", "y", "z", "phi", "psi", "l"))
xdot, ydot, zdot, phidot, psidot = (real_symbol(f"{q}dot") for q in (x, y, z, phi, psi))


def with_trailer(drawbar=0.8, sign=1):
    """A car and a trailer in the rates of x, y and two headings."""
    X = xdot + l * psidot * sp.sin(psi)
    Y = ydot - l * psidot * sp.cos(psi)
    return Mechanism(
        name="trailer",
        frame=coordinates(x, y, phi, psi),
        lagrangian=(xdot**2 + ydot**2 + phidot**2 + psidot**2) / 2,
        constraints=(
            ydot * sp.cos(phi) - xdot * sp.sin(phi),
            sign * (Y * sp.cos(psi) - X * sp.sin(psi)),
        ),
        parameters=(Parameter(l, "length", drawbar, "m"),),
    )


@pytest.mark.parametrize("sign", [1, -1, 3])
def test_wheels_and_the_rod_between_them(sign):
    plan = plan_of(with_trailer(0.8, sign))
    assert plan.path == (x, y)
    at = {x: 1.0, y: 2.0, phi: 0.3, psi: -0.4}
    behind = (1.0 - 0.8 * np.cos(-0.4), 2.0 - 0.8 * np.sin(-0.4))
    numbers = [[float(e.subs(at)) for e in wheel] for wheel in plan.wheels]
    assert np.allclose([w[:2] for w in numbers], [(1.0, 2.0), behind])
    # a heading has no front: angles count up to half turns
    assert np.allclose(np.tan([w[2] for w in numbers]), np.tan([0.3, -0.4]))
    (rod,) = plan.links
    assert np.allclose([float(sp.sympify(e).subs(at)) for e in rod], [1.0, 2.0, *behind])


def test_in_velocities_of_ones_own():
    u, v, turn = (real_symbol(name) for name in ("u", "v", "Omega"))
    rates = {
        x: u * sp.cos(phi) - v * sp.sin(phi),
        y: u * sp.sin(phi) + v * sp.cos(phi),
        phi: turn,
    }
    # a blade one ahead of (x, y): v + Ω = 0
    sleigh = Mechanism(
        name="sleigh",
        frame=Frame(rates, (u, v, turn)),
        lagrangian=(u**2 + v**2 + turn**2) / 2,
        constraints=(v + turn,),
    )
    (wheel,) = plan_of(sleigh).wheels
    at = {x: 0.0, y: 0.0, phi: 0.7}
    assert np.allclose([float(e.subs(at)) for e in wheel[:2]], [np.cos(0.7), np.sin(0.7)])


def test_what_rolls_along_its_heading_is_no_wheel_of_its_own():
    """ẋ = R ψ̇ cos φ says how far it rolls, and no place lies at a constant distance."""
    disk = Mechanism(
        name="disk",
        frame=coordinates(x, y, phi, psi),
        lagrangian=(xdot**2 + ydot**2 + phidot**2 + psidot**2) / 2,
        constraints=(
            xdot * sp.cos(phi) + ydot * sp.sin(phi) - psidot,
            ydot * sp.cos(phi) - xdot * sp.sin(phi),
        ),
    )
    assert len(plan_of(disk).wheels) == 1


def test_without_a_plane_there_is_no_plan():
    flat = Mechanism(
        name="space", frame=coordinates(x, y, z), lagrangian=(xdot**2 + ydot**2 + zdot**2) / 2
    )
    assert plan_of(flat) is None
    line = Mechanism(name="line", frame=coordinates(x), lagrangian=xdot**2 / 2)
    assert plan_of(line) is None
