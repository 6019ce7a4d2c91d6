"""§9.3: sphero-conical coordinates, Chaplygin form, Hamiltonian form on e(3)."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Identity
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors
from nonholonomic.catalogue.ball_on_sphere import (
    rubber_ball_on_e3 as e3,
    rubber_ball_ratio as ratio,
    rubber_ball_sphero_conical as conical,
)
from nonholonomic.catalogue.ball_on_sphere.rubber_ball_ratio import DET_J, RHO_SQUARED, J, k
from nonholonomic.catalogue.ball_on_sphere.rubber_ball_separated import PLAIN, roots
from nonholonomic.catalogue.ball_on_sphere.rubber_ball_sphero_conical import (
    cubic,
    eta,
    p_eta,
    p_xi,
    xi,
)

from ..claim import Case, Claim, Remark

omega, n, gamma = vectors("omega n gamma")
z = real_symbol("z")
COORDINATES = roots(xi, eta, *PLAIN)
J_1, J_2, J_3 = J.symbols
n_1, n_2, n_3 = n.symbols


def with_point() -> System:
    """(9.2) with an additional number z."""
    system = ratio.rolling()
    extra = Parameter(z, "argument of f", 0.7, "kg m^2")
    return replace(system, parameters=(*system.parameters, extra))


def in_coordinates(name: str, *equations: sp.Expr) -> Case:
    """Equations that the roots ξ, η of (9.5) satisfy on the phase space of (9.2)."""
    return with_point(), Identity(name, equations, quantities=COORDINATES)


def conics() -> Case:
    """(9.5), the second equality."""
    partial = sp.Add(*(s**2 / (j - z) for s, j in zip(n.symbols, J.symbols, strict=True)))
    return in_coordinates("conics", partial - (z - xi) * (z - eta) / cubic(z))


def interlaced() -> Case:
    """The signs of (Jᵢ − ξ)(Jᵢ − η), as squares times differences of moments."""
    return in_coordinates(
        "order",
        (J_1 - xi) * (J_1 - eta) - n_1**2 * (J_2 - J_1) * (J_3 - J_1),
        (J_2 - xi) * (J_2 - eta) + n_2**2 * (J_2 - J_1) * (J_3 - J_2),
        (J_3 - xi) * (J_3 - eta) - n_3**2 * (J_3 - J_1) * (J_3 - J_2),
    )


def squares() -> Case:
    """(9.6)."""
    equations = (s**2 - conical.square(i, xi, eta) for i, s in enumerate(n.symbols))
    return in_coordinates("squares", *equations)


def kinetic(sign: int) -> Case:
    """(9.7) against ½(ω, Jω), for arbitrary ξ̇, η̇."""
    system = conical.in_chaplygin_form(conical.kinetic(), conical.GYROSCOPIC)
    excess = conical.kinetic(sign) - dot(omega, J * omega) / 2
    return system, Identity("kinetic", excess, "kinetic energy")


def chaplygin_form() -> Case:
    """(9.8) with T = ½(ω, Jω), mapped to (9.2)."""
    return conical.in_chaplygin_form(conical.kinetic(), conical.GYROSCOPIC), conical.to_ball()


def momentum_measure() -> Case:
    """The measure in ξ, η and the momenta."""
    return conical.momentum_form(), conical.MOMENTUM_MEASURE


def radius() -> Case:
    """(9.9), the first formula."""
    return in_coordinates("radius", RHO_SQUARED - xi * eta / DET_J)


def canonical(*levels: sp.Expr) -> Case:
    """(9.10), on a level of k if one is given."""
    return conical.momentum_form(), replace(conical.to_canonical(), level=levels)


def at_both() -> Case:
    """Conformally Hamiltonian for k = 1 and for k = −1."""
    system = conical.momentum_form()
    first, second = (replace(conical.to_canonical(), level=(k - value,)) for value in (1, -1))
    return (system, first), (system, second)


def half() -> Case:
    """k = ½: Hamiltonian in the original time, with the momenta ∂T/∂ξ̇, ∂T/∂η̇."""
    momenta = {p_xi: conical.P_xi, p_eta: conical.P_eta}
    energy = conical.hamiltonian().subs({k: sp.Rational(1, 2)}).xreplace(momenta)
    law = ConformallyHamiltonian(
        "hamiltonian", sp.S.One, conical.CANONICAL, energy, level=(2 * k - 1,)
    )
    return conical.momentum_form(), law


def modified(power: int) -> Case:
    """Ñ in terms of N ρ^power compared with Ñ in terms of (n, J⁻¹n)."""
    first = sp.sqrt(DET_J) * ratio.REDUCING * RHO_SQUARED ** sp.Rational(power, 2) / k
    return ratio.rolling(), Identity("factor", first - ratio.N_TILDE, "two expressions of Ñ")


def casimirs() -> Case:
    """(9.12)."""
    area = dot(ratio.MOMENTUM, ratio.DIRECTION)
    values = (
        norm_squared(ratio.DIRECTION) - 1,
        area - ratio.N_TILDE / sp.sqrt(RHO_SQUARED) * dot(omega, n),
        area,
    )
    return ratio.rolling(), Identity("casimirs", values, "γ² and (M, γ)")


def _on_coordinates() -> tuple[list[sp.Expr], list[sp.Expr]]:
    """M and γ of (9.11) in terms of ξ, η, p_ξ, p_η.

    In M = Ñ J^(1/2) ω, with ω from q̇ = N ∂H/∂p, the powers of ξη combine: N⁻² is the power in the
    Hamiltonian, and Ñ/N is √det J ρ²/k.
    """
    rho_squared = xi * eta / DET_J
    free = conical.hamiltonian() / rho_squared ** ((2 * k - 1) / k)
    place = dict(zip(n.symbols, conical.normal(), strict=True))
    turning = conical.turning(sp.diff(free, p_xi), sp.diff(free, p_eta))
    spin = [sp.factor(w).xreplace(place) for w in scalars(cross(turning, n) / k)]
    halves = [sp.sqrt(j) for j in J.symbols]
    factor = sp.sqrt(DET_J) * rho_squared / k
    momentum = [factor * s * w for s, w in zip(halves, spin, strict=True)]
    shrunk = [x / s for x, s in zip(conical.normal(), halves, strict=True)]
    return momentum, [x / sp.sqrt(rho_squared) for x in shrunk]


def _bracket(first: sp.Expr, second: sp.Expr) -> sp.Expr:
    """The canonical bracket, {ξ, p_ξ} = {η, p_η} = 1."""
    pairs = ((xi, p_xi), (eta, p_eta))
    return sp.Add(
        *(
            sp.diff(first, q) * sp.diff(second, p) - sp.diff(first, p) * sp.diff(second, q)
            for q, p in pairs
        )
    )


def algebra() -> Case:
    """(9.13), from the canonical bracket of ξ, η, p_ξ, p_η, where J₁ < η < J₂ < ξ < J₃."""
    momentum, direction = _on_coordinates()
    values = []
    for i, j in ((0, 1), (1, 2), (2, 0)):
        other = 3 - i - j
        values += [
            _bracket(momentum[i], momentum[j]) + momentum[other],
            _bracket(momentum[i], direction[j]) + direction[other],
            _bracket(momentum[j], direction[i]) - direction[other],
            _bracket(direction[i], direction[j]),
        ]
    values += [_bracket(momentum[i], direction[i]) for i in range(3)]
    order = (J_1, eta, J_2, xi, J_3)
    guards = tuple(
        Guard(f"order {i}", above - below, "two coordinates meet")
        for i, (below, above) in enumerate(pairwise(order), 1)
    )
    system = replace(conical.canonical_form(), guards=guards)
    return system, Identity("brackets", tuple(values), "brackets of M and γ")


def energy_on_e3() -> Case:
    """(9.14): ½(ω, Jω) = ½Ñ⁻²M² = ½(k²/det J)(γ, Jγ)^(1/k) M²."""
    kinetic_energy = dot(omega, J * omega) / 2
    square = norm_squared(ratio.MOMENTUM)
    stretch = dot(ratio.DIRECTION, J * ratio.DIRECTION)
    values = (
        kinetic_energy - square / ratio.N_TILDE**2 / 2,
        kinetic_energy - k**2 / DET_J * stretch ** (1 / k) * square / 2,
    )
    return ratio.rolling(), Identity("energy", values, "kinetic energy in M and γ")


def energy_in_coordinates() -> Case:
    """(9.14), the last expression against ½(ω, Jω)."""
    energy = conical.hamiltonian()
    values = (energy - dot(omega, J * omega) / 2, energy - conical.H)
    return conical.canonical_form(), Identity("energy", values, "kinetic energy in ξ, η")


def equations_on_e3() -> Case:
    """The map from (9.2) to the Hamiltonian system of (9.13), (9.14)."""
    return ratio.rolling(), ratio.to_e3()


def lie_poisson() -> Case:
    """(9.13) is a Poisson bracket with the Casimir functions F₁, F₂."""
    return e3.hamiltonian_form(), e3.STRUCTURE


CLAIMS = (
    Claim(
        "(9.5)",
        r"$\frac{n_1^2}{J_1-z} + \frac{n_2^2}{J_2-z} + \frac{n_3^2}{J_3-z} = "
        r"\frac{(z-\xi)(z-\eta)}{A(z)}$, $A(z) = (J_1-z)(J_2-z)(J_3-z)$.",
        conics,
    ),
    Claim(
        "§9.3, after (9.5)",
        r"$0 < J_1 < \xi < J_2 < \eta < J_3$.",
        interlaced,
        note="it is shown that (z − ξ)(z − η) is n₁²(J₂−J₁)(J₃−J₁) ≥ 0 at J₁, −n₂²(J₂−J₁)(J₃−J₂) "
        "≤ 0 at J₂ and n₃²(J₃−J₁)(J₃−J₂) ≥ 0 at J₃; for J = diag(1, 2, 3) and "
        "n = (0, 3/5, 4/5) ξ is J₁",
        where=("n₁n₂n₃ ≠ 0", "J₁ < J₂ < J₃"),
    ),
    Claim(
        "(9.6)",
        r"$n_1^2 = \frac{(J_1-\xi)(J_1-\eta)}{(J_1-J_2)(J_1-J_3)}$ and so on in turn.",
        squares,
    ),
    Claim(
        "§9.3, ω after (9.6)",
        r"$\boldsymbol\omega = k^{-1}\dot{\mathbf n}\times\mathbf n$.",
        lambda: (ratio.rolling(), ratio.velocity_from_normal()),
    ),
    Claim(
        "(9.7)",
        r"$T = \frac{\xi-\eta}{8k^2}\left(-\frac{\eta\dot\xi^2}{A(\xi)} + "
        r"\frac{\xi\dot\eta^2}{A(\eta)}\right)$.",
        lambda: kinetic(-1),
        lambda: kinetic(1),
        r"$T = \frac{\xi-\eta}{8k^2}\left(\frac{\eta\dot\xi^2}{A(\xi)} - "
        r"\frac{\xi\dot\eta^2}{A(\eta)}\right)$",
        "the sign: as printed T is negative, since ξ < η, A(ξ) < 0 < A(η)",
    ),
    Claim(
        "(9.8)",
        r"$\frac{d}{dt}\frac{\partial T}{\partial\dot\xi} - \frac{\partial T}{\partial\xi} = "
        r"\dot\eta S$, $\frac{d}{dt}\frac{\partial T}{\partial\dot\eta} - "
        r"\frac{\partial T}{\partial\eta} = -\dot\xi S$, $S = \frac{2k-1}{8k^3}(\xi-\eta)"
        r"\left(\frac{\dot\xi}{A(\xi)} + \frac{\dot\eta}{A(\eta)}\right)$.",
        chaplygin_form,
        note="with T = ½(ω, Jω), that is (9.7) with the sign corrected",
    ),
    Claim(
        "§9.3, measure before (9.9)",
        r"In $P_\xi = \partial T/\partial\dot\xi$, $P_\eta = \partial T/\partial\dot\eta$ the "
        r"invariant measure takes the form $(\mathbf n,\mathbf J^{-1}\mathbf n)^{-1+\frac{1}{2k}}"
        r"dP_\xi\,dP_\eta\,d\xi\,d\eta$.",
        momentum_measure,
    ),
    Claim(
        "(9.9)",
        r"$\rho^2 = (\mathbf n,\mathbf J^{-1}\mathbf n) = \frac{\xi\eta}{\det\mathbf J}$.",
        radius,
    ),
    Claim(
        "(9.10)",
        r"After the change of time $\mathcal N dt = d\tau$ with $\mathcal N = "
        r"\left(\frac{\xi\eta}{\det\mathbf J}\right)^{-1+\frac{1}{2k}}$ of (9.9) the equations of "
        r"motion become canonical: $\xi' = \partial T/\partial p_\xi$, …, "
        r"$p'_\eta = -\partial T/\partial\eta$; $\mathcal N$ is a reducing multiplier.",
        canonical,
        note="with p = N ∂T/∂q̇ and T expressed in ξ, η, p_ξ, p_η",
    ),
    Claim(
        "§9.3, after (9.10)",
        r"For $k = \pm1$ the system (9.2) is conformally Hamiltonian.",
        at_both,
        note="true, and so it is for every k, by (9.10)",
    ),
    Claim(
        "§9.3, k = 1/2",
        r"For $k = \frac12$ ($a = b$) the system (9.2), (9.8) is an ordinary Hamiltonian system.",
        half,
        note="in ξ, η and the momenta ∂T/∂ξ̇, ∂T/∂η̇, in the time t",
    ),
    Claim(
        "§9.3, Ñ",
        r"$\tilde{\mathcal N} = \frac{\sqrt{\det\mathbf J}\,\mathcal N}{k\rho^2} = "
        r"\frac{\sqrt{\det\mathbf J}}{k}(\mathbf n,\mathbf J^{-1}\mathbf n)^{\frac{1}{2k}}$.",
        lambda: modified(-2),
        lambda: modified(2),
        r"$\tilde{\mathcal N} = \frac{\sqrt{\det\mathbf J}\,\mathcal N\rho^2}{k} = "
        r"\frac{\sqrt{\det\mathbf J}}{k}(\mathbf n,\mathbf J^{-1}\mathbf n)^{\frac{1}{2k}}$",
        "ρ² stands in the denominator; the second expression is the right one, by (9.13), (9.14)",
    ),
    Claim(
        "(9.12)",
        r"$(\boldsymbol\gamma,\boldsymbol\gamma) = 1$, $(\mathbf M,\boldsymbol\gamma) = "
        r"\frac{\tilde{\mathcal N}}{\rho}(\boldsymbol\omega,\mathbf n) = 0$ for $\mathbf M = "
        r"\tilde{\mathcal N}\mathbf J^{1/2}\boldsymbol\omega$, $\boldsymbol\gamma = "
        r"\frac1\rho\mathbf J^{-1/2}\mathbf n$ of (9.11).",
        casimirs,
    ),
    Claim(
        "(9.13)",
        r"$\{M_i,M_j\} = -\varepsilon_{ijk}M_k$, $\{M_i,\gamma_j\} = -\varepsilon_{ijk}\gamma_k$, "
        r"$\{\gamma_i,\gamma_j\} = 0$.",
        algebra,
        note="from {ξ, p_ξ} = {η, p_η} = 1 and (9.11) with Ñ = (√det J / k)(n, J⁻¹n)^(1/(2k))",
    ),
    Claim(
        "(9.14), first line",
        r"$\mathcal H = T = \frac12\tilde{\mathcal N}^{-2}\mathbf M^2 = "
        r"\frac12\frac{k^2}{\det\mathbf J}(\boldsymbol\gamma,\mathbf J\boldsymbol\gamma)^{1/k}"
        r"\mathbf M^2$.",
        energy_on_e3,
        note="with Ñ = (√det J / k)(n, J⁻¹n)^(1/(2k))",
    ),
    Claim(
        "(9.14), second line",
        r"$\mathcal H = \frac{2k^2}{\xi-\eta}\left(\frac{\xi\eta}{\det\mathbf J}\right)^{(2k-1)/k}"
        r"\left(\frac{A(\xi)}{\eta}p_\xi^2 - \frac{A(\eta)}{\xi}p_\eta^2\right)$.",
        energy_in_coordinates,
        note="the sign is right here, and contradicts that of (9.7)",
    ),
    Claim(
        "(9.13), (9.14), equations of motion",
        r"After the change of time $\mathcal N dt = d\tau$ the equations (9.2) are those of the "
        r"Hamiltonian (9.14) with the bracket (9.13).",
        equations_on_e3,
    ),
    Claim(
        "§9.3, after (9.14)",
        r"(9.13) is a Lie–Poisson bracket of $e(3)$ with the Casimir functions $F_1 = "
        r"(\mathbf M,\boldsymbol\gamma)$, $F_2 = (\boldsymbol\gamma,\boldsymbol\gamma)$.",
        lie_poisson,
    ),
)

REMARKS = (
    Remark(
        "§9.3, after (9.10)",
        "The conformally Hamiltonian form was first discovered in [14] by other techniques.",
        "literature",
    ),
    Remark("§9.3, after (9.10)", "The coordinates ξ, η are local.", "explanation"),
)
