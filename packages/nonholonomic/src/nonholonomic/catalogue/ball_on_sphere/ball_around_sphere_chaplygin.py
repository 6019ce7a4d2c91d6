"""The hollow ball around a sphere, k = −1, F₂ = 0, as a Chaplygin system (§8.2, (8.5), (8.6)).

u, v are sphero-conical coordinates of n, the roots of Σ n_i²/(J_i − u) = 0, and P_u, P_v the
derivatives of the energy T by their rates.  With p(u) = ∏(u − J_i) and
L = M − Bn (n, M)/(n, Bn), which is orthogonal to n,

    2H = (L, J⁻¹L) + d (L, J⁻¹n)²/ρ² − (L, An)²/(An, Bn),
    L_i = 2 n_j n_k (J_j − J_k) (P_u (J_i − u) − P_v (J_i − v)) / (v − u).

The equations are Ṗ_u = −∂H/∂u + v̇Φ, Ṗ_v = −∂H/∂v − u̇Φ, and Φ = (P_v ∂𝒩/∂u − P_u ∂𝒩/∂v)/𝒩
follows from the reducing multiplier 𝒩.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Law, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Diagonal, real_symbol

J = Diagonal("J")
J_1, J_2, J_3 = J.symbols
u, v, P_u, P_v, d = (real_symbol(name) for name in ("u", "v", "P_u", "P_v", "d"))
TRACE, SQUARES, DET = J_1 + J_2 + J_3, J_1**2 + J_2**2 + J_3**2, J_1 * J_2 * J_3
_CYCLE = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
_HALF = sp.S.Half
MISPRINT = "the sign of ΣJ in the numerator of 𝒩"


def _cubic(z: sp.Expr) -> sp.Expr:
    return sp.Mul(*(z - j for j in J.symbols))


def numerator(sign: int = -1) -> sp.Expr:
    """−2 (n, Bn) in the coordinates; the source prints 2d + ΣJ instead of 2d − ΣJ."""
    return 2 * u * v + (u + v) * (2 * d + sign * TRACE) + SQUARES - d * TRACE


def form() -> sp.Expr:
    """δ = 4 (An, Bn) in the coordinates."""
    total = u + v
    start = 4 * DET + 2 * TRACE * SQUARES - TRACE**3 - d * TRACE**2
    return start + (TRACE**2 - 2 * SQUARES + 4 * d * TRACE) * total - 4 * d * total**2


def area() -> sp.Expr:
    """det I_Q = det(J − d n⊗n) = det J − d u v."""
    return DET - d * u * v


def energy() -> sp.Expr:
    """H(u, v, P_u, P_v)."""
    gap, both = v - u, _cubic(u) * _cubic(v)
    free = (
        P_u**2 * _cubic(u) * (gap / v - u * _cubic(v) / (v * DET))
        + 2 * P_u * P_v * both / DET
        + P_v**2 * _cubic(v) * (-gap / u - v * _cubic(u) / (u * DET))
    )
    spun = -d * both * (u * P_u - v * P_v) ** 2 / (DET * area())
    tied = -4 * both * (P_u - P_v) ** 2 / form()
    return 2 * (free + spun - tied) / gap**2


def rates() -> tuple[sp.Expr, sp.Expr]:
    """The rates of u and v."""
    return sp.diff(energy(), P_u), sp.diff(energy(), P_v)


def force(top: sp.Expr) -> sp.Expr:
    """Φ that follows from the multiplier with the given numerator."""
    bases = ((top, sp.S.One), (form(), -sp.S.One), (area(), -_HALF))
    slopes = [sp.Add(*(power * sp.diff(b, z) / b for b, power in bases)) for z in (u, v)]
    return P_v * slopes[0] - P_u * slopes[1]


def chaplygin_system(force_u: sp.Expr, force_v: sp.Expr, *laws: Law) -> System:
    """(8.6) with given forces in the equations for P_u and P_v."""
    moments = (
        Parameter(s, f"moment of inertia about a tangent along body axis {i}", value, "kg m^2")
        for i, (s, value) in enumerate(zip(J.symbols, (2.0, 2.5, 3.1), strict=True), 1)
    )
    meaning = "mass times the square of the ball's radius"
    du, dv = rates()
    return System(
        name="ball-around-sphere-chaplygin",
        title="Hollow ball around a sphere as a Chaplygin system",
        summary="A hollow ball around a sphere of half its radius, with vanishing linear integral, "
        "in sphero-conical coordinates.",
        source="§8.2, (8.6)",
        parameters=(*moments, Parameter(d, meaning, 1.0, "kg m^2", (d >= 0,))),
        field={
            u: du,
            v: dv,
            P_u: -sp.diff(energy(), u) + force_u,
            P_v: -sp.diff(energy(), v) + force_v,
        },
        laws=laws,
    )


def square(i: int) -> sp.Expr:
    """n_i²."""
    moment = J.symbols[i]
    others = [moment - J.symbols[k] for k in range(3) if k != i]
    return (moment - u) * (moment - v) / sp.Mul(*others)


def momentum() -> sp.Expr:
    """M² = L² − 2 (L, Bn)(L, An)/(An, Bn) + |Bn|² (L, An)²/(An, Bn)²."""
    half, gap, total = TRACE / 2, v - u, u + v
    both = _cubic(u) * _cubic(v)
    # (L, An)² = −4 both (P_u − P_v)²/gap², and so on for (L, JAn)(L, An)
    leaning = P_u - P_v
    drawn = P_u * (half - u) - P_v * (half - v)
    mean = total - half
    product = -numerator() / 2 + d * mean
    # (n, J²A²n), from the complete symmetric functions of J
    pairs = (TRACE**2 - SQUARES) / 2
    twice = TRACE**2 - pairs
    thrice = TRACE**3 - 2 * TRACE * pairs + DET
    fourth = TRACE**4 - 3 * TRACE**2 * pairs + pairs**2 + 2 * TRACE * DET
    second = twice - TRACE * total + u * v
    third = thrice - twice * total + TRACE * u * v
    last = fourth - thrice * total + twice * u * v
    length = half**2 * second - 2 * half * third + last - 2 * d * mean * product + d**2 * mean**2
    free = 4 * (_cubic(u) * P_u**2 - _cubic(v) * P_v**2) / gap
    tied = 32 * leaning * drawn / form() - 64 * length * leaning**2 / form() ** 2
    return free + both / gap**2 * tied


def ball() -> Identity:
    """ṅ = ω×n, H and M² of the ball, with M_i = n_j n_k μ_i, ω_i = n_j n_k o_i, ṅ_i = n_i ν_i.

    Together with both integrals this gives Ṁ = M×ω: what is left of it, R = Ṁ − M×ω, obeys
    (An, R) = 0 by F₂ = 0, (ω, R) = 0 by the energy, (M, R) = 0 by M².
    """
    moments, squares = J.symbols, [square(i) for i in range(3)]
    half = TRACE / 2
    spread = (J_1 - J_2) * (J_2 - J_3) * (J_3 - J_1)
    # (L, An) = n₁n₂n₃ tilt
    tilt = 2 * spread * (P_u - P_v) / (v - u)
    mean = u + v - half
    momenta, stretch = [], []
    du, dv = rates()
    for i, j, k in _CYCLE:
        moment = moments[i]
        along = P_u * (moment - u) - P_v * (moment - v)
        free = 2 * (moments[j] - moments[k]) * along / (v - u)
        drawn = moment * (half - moment) - d * mean
        momenta.append(free - 4 * squares[i] * drawn * tilt / form())
        stretch.append(-(du / (moment - u) + dv / (moment - v)) / 2)
    # (n, J⁻¹M) = n₁n₂n₃ share
    share = sp.Add(*(x / j for x, j in zip(momenta, moments, strict=True)))
    spins = [
        x / j + d * DET / area() * share * s / j
        for x, j, s in zip(momenta, moments, squares, strict=True)
    ]
    kinematics = [stretch[i] - squares[k] * spins[j] + squares[j] * spins[k] for i, j, k in _CYCLE]
    doubled = [squares[j] * squares[k] * momenta[i] * spins[i] for i, j, k in _CYCLE]
    length = [squares[j] * squares[k] * momenta[i] ** 2 for i, j, k in _CYCLE]
    return Identity(
        "ball",
        (*kinematics, sp.Add(*doubled) / 2 - energy(), sp.Add(*length) - momentum()),
        "the ball's motion, energy and momentum",
        source="(8.6)",
    )


def sums(top: sp.Expr) -> Identity:
    """The parts of 𝒩 as sums over the axes: −2 (n, Bn), 4 (An, Bn), det I_Q; and n² = 1."""
    triples = [(square(i), j, TRACE / 2 - j) for i, j in enumerate(J.symbols)]
    mean = sp.Add(*(s * a for s, _, a in triples))
    drawn = sp.Add(*(s * j * a for s, j, a in triples)) - d * mean
    leaned = sp.Add(*(s * j * a**2 for s, j, a in triples)) - d * mean**2
    inverse = sp.Add(*(s / j for s, j, _ in triples))
    return Identity(
        "multiplier",
        (
            sp.Add(*(s for s, _, _ in triples)) - 1,
            form() - 4 * leaned,
            area() - DET * (1 - d * inverse),
            top + 2 * drawn,
        ),
        "the reducing multiplier −𝒩 = (n, Bn)/(2 (An, Bn) √det I_Q) in the coordinates",
        source="§8.2",
    )


def density(top: sp.Expr) -> Measure:
    """The measure 𝒩 du dv dP_u dP_v, with the numerator of 𝒩 given."""
    return Measure(
        "measure",
        {top: 1, form(): -1, area(): -_HALF},
        "measure 𝒩 du dv dP_u dP_v",
        source="§8.2, before (8.7)",
    )


def reduced_system() -> System:
    """(8.6) with the right multiplier."""
    top = numerator()
    push = force(top)
    du, dv = rates()
    return chaplygin_system(
        dv * push,
        -du * push,
        Integral("energy", energy(), "energy", source="(8.2)", unit="J"),
        Integral(
            "second", momentum(), "square of the momentum", source="(8.2)", unit="kg^2 m^4/s^2"
        ),
        replace(density(top), as_printed=density(numerator(1)), misprint=MISPRINT),
        replace(sums(top), as_printed=sums(numerator(1)), misprint=MISPRINT),
        ball(),
    )
