"""§6.1: equations of motion and conservation laws of the Veselova system."""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Measure, Rate
from flowlanes.system.system import System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared, real_symbol, vectors
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.angles import theta
from nonholonomic.catalogue.fixed_point import veselova as catalogue, veselova_spinning
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods.independence import independent, rational_point
from ..methods.veselova_in_angles import (
    ANGLES,
    RATES,
    T_0,
    body as in_angles,
    constrained,
    psi,
    psidot,
    slope_of_potential,
)

omega, gamma = vectors("omega gamma")
I = Diagonal("I")
lambda_0 = real_symbol("lambda_0")
HALF = sp.Rational(1, 2)
#: The Euler angles θ, φ, ψ and their rates.
COORDINATES, SPEEDS = (*ANGLES, psi), (*RATES, psidot)
U = catalogue.ANY
TORQUE = cross(I * omega, omega) + cross(gamma, gradient(U, gamma))
#: The formula printed for λ₀ in (6.1).
PRINTED = dot(TORQUE, I**-1 * gamma) / dot(gamma, I**-1 * gamma)


@cache
def body() -> System:
    """The body in an unspecified potential, with (ω, γ) = 0."""
    return catalogue.general()


@cache
def free_body() -> System:
    """The body without a field."""
    return from_catalogue("veselova")


def equations() -> Case:
    """Euler's equations with a torque along γ, and Lagrange's equations in Euler angles.

    With the constraint (6.6), the multiplier Λ enters the equations for θ, φ, ψ with the factors
    0, cos θ, 1.
    """
    reaction = I * rate(omega) - TORQUE
    nutation, rotation, precession = (
        _lagrange(q, s) for q, s in zip(COORDINATES, SPEEDS, strict=True)
    )
    return (
        (
            body(),
            Identity(
                "equations",
                (reaction - dot(gamma, reaction) * gamma, rate(gamma) - cross(gamma, omega)),
            ),
        ),
        (in_angles(), Identity("lagrange", (nutation, rotation - sp.cos(theta) * precession))),
        (in_angles(), in_angles().laws[0]),
    )


def _lagrange(coordinate: sp.Symbol, speed: sp.Symbol) -> sp.Expr:
    """d/dt ∂T₀/∂q̇ − ∂T₀/∂q + ∂U/∂q along the motion."""
    left = Rate(constrained(sp.diff(T_0, speed))) - constrained(sp.diff(T_0, coordinate))
    return left if coordinate == psi else left + slope_of_potential(coordinate)


def multiplier(sign: int) -> Case:
    """The torque along γ that preserves (ω, γ) = 0, up to a sign."""
    system = body()
    reaction = I * rate(omega) - TORQUE
    return (
        (system, Integral("constraint", dot(omega, gamma))),
        (system, Identity("multiplier", dot(gamma, reaction) - sign * PRINTED)),
    )


def energy() -> Case:
    """(6.2), energy."""
    return body(), Integral("energy", HALF * dot(I * omega, omega) + U)


def geometric() -> Case:
    """(6.2), γ²."""
    return body(), Integral("geometric", norm_squared(gamma))


def measure() -> Case:
    """(6.3)."""
    return body(), Measure("measure", {dot(gamma, I**-1 * gamma): HALF})


def square() -> Case:
    """(6.4)."""
    momentum = I * omega
    value = norm_squared(momentum) - dot(momentum, gamma) ** 2
    system = free_body()
    return (
        (system, Integral("F", value)),
        (system, Identity("square", value - norm_squared(cross(momentum, gamma)))),
    )


def euler_jacobi() -> Case:
    """γ², (ω, γ), H and F have independent differentials."""
    system = free_body()
    momentum = I * omega
    state = dict(zip(map(str, system.symbols), ("3", "0", "-1", "2/7", "3/7", "6/7"), strict=True))
    return independent(
        system,
        (
            norm_squared(gamma),
            dot(omega, gamma),
            HALF * dot(momentum, omega),
            norm_squared(cross(momentum, gamma)),
        ),
        rational_point(system, state),
    )


def bruns() -> Case:
    """F − K det I (γ, I⁻¹γ) in the field ½K(γ, Iγ); the printed integral has K = 2."""
    system = from_catalogue("veselova-bruns")
    return system, catalogue.momentum_in_bruns_field()


def separated() -> Case:
    """uv (u − v)² ż² = 4z A(z)(2hz − F) for z = u, v."""
    return free_body(), catalogue.separation()


def generalised() -> Case:
    """Three integrals and a measure for any (ω, γ) = d."""
    system = veselova_spinning.spinning(catalogue.NUMBERS)
    return (
        (system, veselova_spinning.spin()),
        (system, veselova_spinning.energy_of_spinning(catalogue.FREE)),
        (system, catalogue.momentum()),
        (system, catalogue.measure()),
    )


CLAIMS = (
    Claim(
        "(6.1)",
        r"$I\dot{\omega} = I\omega \times \omega + \lambda_0\gamma + \gamma \times "
        r"\frac{\partial U}{\partial\gamma}$, $\dot{\gamma} = \gamma \times \omega$",
        equations,
        note="with the multiplier λ₀ that keeps (ω, γ) = 0; judged by Lagrange's equations with "
        "a multiplier in Euler angles",
    ),
    Claim(
        "(6.1), λ₀",
        r"$\lambda_0 = \frac{(I\omega \times \omega + \gamma \times \frac{\partial U}"
        r"{\partial\gamma}, I^{-1}\gamma)}{(\gamma, I^{-1}\gamma)}$",
        lambda: multiplier(1),
        lambda: multiplier(-1),
        r"$\lambda_0 = -\frac{(I\omega \times \omega + \gamma \times \frac{\partial U}"
        r"{\partial\gamma}, I^{-1}\gamma)}{(\gamma, I^{-1}\gamma)}$",
        "missing minus sign, which (1.22) has",
    ),
    Claim(
        "(6.2), energy",
        r"$H = \frac{1}{2}(I\omega, \omega) + U(\gamma)$ is an integral.",
        energy,
    ),
    Claim("(6.2), geometric integral", r"$\gamma^2 = 1$ is preserved.", geometric),
    Claim(
        "(6.3)",
        r"The measure $\rho_\omega d^3\omega d^3\gamma$ with "
        r"$\rho_\omega = \sqrt{(\gamma, I^{-1}\gamma)}$ is invariant.",
        measure,
    ),
    Claim(
        "(6.4)",
        r"When $U = 0$, there is the integral $F = (I\omega, I\omega) - (I\omega, \gamma)^2 = "
        r"|I\omega \times \gamma|^2$.",
        square,
    ),
    Claim(
        "§6.1, after (6.4)",
        "The system is integrable according to Theorem 5: with the measure, n − 2 = 4 "
        "independent integrals.",
        euler_jacobi,
    ),
    Claim(
        "Remark 15",
        r"The integral (6.4) is generalized when the Bruns potential $U = (\gamma, I\gamma)$ is "
        "added.",
        bruns,
        note=r"the integral is $F - 2\det I\,(\gamma, I^{-1}\gamma)$; with "
        r"$U = \frac{K}{2}(\gamma, I\gamma)$ it is $F - K\det I\,(\gamma, I^{-1}\gamma)$",
    ),
    Claim(
        "Remark 16",
        "For U = 0 an explicit integration in sphero-conical coordinates is possible.",
        separated,
        note="the roots z = u, v of Σ γᵢ²/(Iᵢ − z) obey uv(u − v)²ż² = 4z(I₁ − z)(I₂ − z)(I₃ − z)"
        "(2hz − F)",
    ),
    Claim(
        "Remark 18",
        r"The Veselova system with $(\omega, \gamma) = d \neq 0$ and $U = 0$ is integrable.",
        generalised,
        note="decided: besides γ² and (ω, γ) it keeps ½(ω, Iω) − (ω, γ)(Iω, γ), (6.4) and the "
        "measure (6.3); the energy (6.2) is not kept. The explicit solution is cited from [59]",
    ),
)

REMARKS = (
    Remark(
        "§6.1, first paragraph",
        "The Veselova constraint is reciprocal to the Suslov constraint.",
        "a comparison",
    ),
    Remark(
        "Remark 15", "Some other integrable potentials are given in [52, 55].", "none is stated"
    ),
    Remark(
        "Remark 16",
        "The system was rediscovered in [56]; its integration in sphero-conical coordinates is "
        "in [57].",
        "literature",
    ),
    Remark(
        "Remark 17",
        "The Veselova system belongs to the LR and L + R systems on Lie groups.",
        "literature",
    ),
)
