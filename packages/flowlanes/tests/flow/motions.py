"""Systems whose Lyapunov exponents are known."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral, Measure, Symmetry
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import cross, dot, real_symbol, vectors

x, y, z, p, q = map(real_symbol, "xyzpq")
sigma, rho, beta = map(real_symbol, ("sigma", "rho", "beta"))


def lorenz() -> System:
    """Lorenz's equations at his parameters: λ₁ = 0.9056, the sum −(σ + 1 + β)."""
    return System(
        "lorenz",
        "Lorenz",
        {x: sigma * (y - x), y: x * (rho - z) - y, z: x * y - beta * z},
        (
            Parameter(sigma, "Prandtl number", 10.0),
            Parameter(rho, "Rayleigh number", 28.0),
            Parameter(beta, "shape", 8 / 3),
        ),
    )


def henon_heiles() -> System:
    """Two degrees of freedom, Hamiltonian, chaotic at the energy 1/8: the sum is zero."""
    energy = (p**2 + q**2 + x**2 + y**2) / 2 + x**2 * y - y**3 / 3
    return System(
        "henon-heiles",
        "Hénon and Heiles",
        {x: p, y: q, p: -x - 2 * x * y, q: -y - x**2 + y**2},
        laws=(Integral("energy", energy), Measure("volume", {sp.S.One: 1})),
    )


def henon_heiles_start(energy: float, height: float, speed: float) -> list[float]:
    """A start with x = 0 and positive p."""
    push = 2 * energy - speed**2 - height**2 + 2 * height**3 / 3
    return [0.0, height, float(push**0.5), speed]


def saddle() -> System:
    """A hyperbolic linear system about a limit cycle's phase: exponents 0.3, −1.1 and 0."""
    return System(
        "saddle",
        "Saddle",
        {x: sp.Rational(3, 10) * x + y, y: -sp.Rational(11, 10) * y, z: sp.S.One},
    )


def top() -> System:
    """Euler's top in its own axes, with I = diag(1, 2, 3)."""
    M, omega = vectors("M omega")
    m_1, m_2, m_3 = M.symbols
    squares = Integral("square", dot(M, M))
    return System(
        "top",
        "Euler's top",
        {M: cross(M, omega)},
        definitions={omega: sp.ImmutableMatrix([m_1, m_2 / 2, m_3 / 3])},
        laws=(Integral("energy", dot(M, omega) / 2), squares),
    )


def carousel() -> System:
    """A limit cycle r = 1 with the exponent −2, turning evenly, and a place that drifts."""
    u, v, s = map(real_symbol, "uvs")
    rest = 1 - u**2 - v**2
    return System(
        "carousel",
        "Carousel",
        {u: u * rest - v, v: v * rest + u, s: u + 2},
        laws=(Symmetry("turning", {u: -v, v: u, s: sp.S.Zero}),),
    )
