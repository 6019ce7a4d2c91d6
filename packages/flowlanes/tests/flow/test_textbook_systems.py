"""Known numbers of textbook systems: exponents, energies, a periodic orbit, another integrator."""

from __future__ import annotations

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.integrator import integrate
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.lyapunov.spectrum import lyapunov_spectrum
from flowlanes.printing.code import lambdify
from flowlanes.system.laws import Integral
from flowlanes.system.system import System


def lorenz() -> System:
    x, y, z = sp.symbols("x y z", real=True)
    field = {x: 10 * (y - x), y: x * (28 - z) - y, z: x * y - sp.Rational(8, 3) * z}
    return System("lorenz", "Lorenz", field)


def test_exponents_of_lorenz() -> None:
    """0.9056, 0 and −14.5723: Sprott, Chaos and Time-Series Analysis (2003)."""
    spectrum = lyapunov_spectrum(lorenz(), [1.0, 1.0, 20.0], t_end=2000.0)
    np.testing.assert_allclose(spectrum.values, [0.9056, -14.5723], atol=0.02)
    # the exponent of the flow is left out, and its growth observed
    ((kind, growth),) = ((item.kind, rate) for item, rate in spectrum.trivial)
    assert kind == "flow"
    assert abs(growth) < 0.01
    # the divergence is constant
    np.testing.assert_allclose(spectrum.values.sum() + growth, -41 / 3, rtol=1e-9)


def test_a_section_of_henon_and_heiles_keeps_the_energy() -> None:
    x, y, u, v = sp.symbols("x y u v", real=True)
    energy = (u**2 + v**2 + x**2 + y**2) / 2 + x**2 * y - y**3 / 3
    field = {x: u, y: v, u: -x - 2 * x * y, v: -y - x**2 + y**2}
    system = System("henon-heiles", "Hénon and Heiles", field, laws=(Integral("energy", energy),))
    level, place, speed = 1 / 8, np.linspace(-0.2, 0.3, 6), 0.1
    forward = np.sqrt(2 * level - speed**2 - place**2 + 2 * place**3 / 3)
    starts = np.column_stack([0 * place, place, forward, 0 * place + speed])
    points = (
        batch_integrator(system, tolerance=1e-14, section=poincare_section(system, "x"))
        .crossings(starts, 100)
        .states
    )
    assert points.shape == (6, 100, 4)
    values = sp.lambdify((x, y, u, v), energy)(*np.moveaxis(points, -1, 0))
    np.testing.assert_allclose(values, level, atol=1e-12)
    np.testing.assert_allclose(points[..., 0], 0, atol=1e-12)
    assert (points[..., 2] > 0).all()


def three_bodies() -> System:
    """Equal masses in a plane: places first, speeds after them."""
    r = [sp.Matrix(sp.symbols(f"x_{i} y_{i}", real=True)) for i in range(3)]
    v = [sp.Matrix(sp.symbols(f"u_{i} v_{i}", real=True)) for i in range(3)]
    field: dict[sp.Symbol, sp.Expr] = {}
    for i in range(3):
        field |= dict(zip(r[i], v[i], strict=True))
    for i in range(3):
        others = [r[j] - r[i] for j in range(3) if j != i]
        pull = sum((d / d.dot(d) ** sp.Rational(3, 2) for d in others), sp.zeros(2, 1))
        field |= dict(zip(v[i], pull, strict=True))
    return System("three-bodies", "Three bodies in a plane", field)


def test_three_bodies_on_a_figure_eight_change_places() -> None:
    """Start and period of Chenciner and Montgomery (2000), as computed by Simó."""
    x, y, u, v = 0.97000436, -0.24308753, 0.93240737, 0.86473146
    places = [x, y, -x, -y, 0.0, 0.0]
    start = [*places, u / 2, v / 2, u / 2, v / 2, -u, -v]
    period = 6.32591398
    motion = integrate(three_bodies(), start, [0.0, period / 3, period])
    np.testing.assert_allclose(motion.states[-1], start, atol=1e-6)
    # after a third of the period each body is where another one was
    there = {tuple(np.round(place, 5)) for place in motion.states[1][:6].reshape(3, 2) + 0.0}
    assert there == {tuple(np.round(place, 5)) for place in np.reshape(places, (3, 2)) + 0.0}


def double_pendulum() -> System:
    a, b, p, q = sp.symbols("a b p q", real=True)
    # lengths, masses and gravity 1; speeds p and q of the angles a and b
    sine, cosine = sp.sin(a - b), sp.cos(a - b)
    below = 2 - cosine**2
    first = -(q**2) * sine - 2 * sp.sin(a)
    second = p**2 * sine - sp.sin(b)
    field = {
        a: p,
        b: q,
        p: (first - cosine * second) / below,
        q: (2 * second - cosine * first) / below,
    }
    energy = p**2 + q**2 / 2 + p * q * cosine - 2 * sp.cos(a) - sp.cos(b)
    return System("double-pendulum", "Double pendulum", field, laws=(Integral("energy", energy),))


def test_the_double_pendulum_agrees_with_another_integrator() -> None:
    system, start = double_pendulum(), [1.0, 0.5, 0.0, 0.0]
    motion = integrate(system, start, [0.0, 10.0])
    other = solve_ivp(lambdify(system), (0.0, 10.0), start, method="DOP853", rtol=1e-13, atol=1e-14)
    np.testing.assert_allclose(motion.states[-1], other.y[:, -1], atol=1e-10)
    assert np.ptp(motion["law_energy"]) < 1e-13
