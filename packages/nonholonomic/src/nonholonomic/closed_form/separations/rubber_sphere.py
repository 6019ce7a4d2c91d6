"""The rubber ball on a sphere, separated, where its ratio of radii allows it (§9.5).

For k = −1, a hollow ball around a sphere of half its radius, the unit vector is
ν = J^(−1/2) n/ρ with ρ² = (n, J⁻¹n), n the normal of the sphere and J = I + mR²; the time has
dτ = dt/ρ.  With 2h = (ω, Jω) and F of (9.4)

    z₁, z₂ roots of Σ n_i²/(J_i (J_i − z)) = 0,     y² = (J₁−z)(J₂−z)(J₃−z) (2hz (tr J − z) − F),
    Σ dz/y = 0,     Σ z dz/y = 2 (det J)^(−1/2) dτ,
    n = ρ J^(1/2) ν,     ρ² = 1/(ν, Jν),     ω = ρ (det J)^(1/2) J^(−1/2) (ν×ν′).

The quadratic 2hz (tr J − z) − F is not positive at the smaller and not negative at the larger of
z₁, z₂, so that its roots are real on every motion; one lies between the least and the greatest of
the poles J_i, the other as far beyond ½ tr J > max J_i.  h = 0 is rest.

No vector fixed in space is known as a formula.  In complex time the equation of the attitude has
poles where (ν, Jν) = 0, around which its solutions make half turns.  The axes of three such half
turns were found not to lie in a plane (numerically, not proven), so no vector algebraic in the
state can be fixed in space.  :mod:`~nonholonomic.closed_form.genus_two.floquet_attitude` finds one
by its Fourier series on the torus.

For k = 1 the sphere is a plane, and the family is the Veselova system with J for I.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from flowlanes.system.system import System
from flowlanes.system.vectors import (
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)

from ...catalogue import from_catalogue
from ...catalogue.ball_on_sphere import rubber_ball_ratio
from ...catalogue.fixed_point import veselova
from ..genus_two.change_of_symbols import in_symbols_of
from ..genus_two.separation import SeparatedSystem, gaps, nu, nuprime
from ..genus_two.separation_laws import with_laws
from .veselova import veselova as without_field

omega, gamma, n, M = vectors("omega gamma n M")
h, F = real_symbol("h"), real_symbol("F")
HALF = sp.Rational(1, 2)


def _tensor(moments: Sequence[sp.Expr], power: sp.Rational) -> sp.ImmutableDenseMatrix:
    """A power of diag(moments)."""
    return constant(sp.diag(*(moment**power for moment in moments)))


def _separation_hollow(
    name: str,
    system: System,
    normal: Vector,
    moments: tuple[sp.Expr, sp.Expr, sp.Expr],
    level: sp.Expr,
) -> SeparatedSystem:
    """The case k = −1 of a system with state ω and `normal`; `level` vanishes for k = −1."""
    trace, det = sp.Add(*moments), sp.Mul(*moments)
    J, A = (_tensor(moments, sp.Integer(power)) for power in (1, -1))
    root, inverse_root = (_tensor(moments, power) for power in (HALF, -HALF))
    rho_2 = dot(normal, A * normal)
    turned = cross(omega, normal)
    rho = 1 / sp.sqrt(dot(nu, J * nu))
    spread = sp.sqrt(trace**2 - 2 * F / h)
    return with_laws(
        SeparatedSystem(
            name=name,
            title="Hollow rubber ball around a sphere of half its radius",
            system=system,
            level=(level,),
            constants=(
                (h, dot(omega, J * omega) / 2),
                (
                    F,
                    (
                        norm_squared(J * omega)
                        + det * dot(omega, J * omega) * norm_squared(A * normal)
                    )
                    / rho_2,
                ),
            ),
            direction=inverse_root * normal / sp.sqrt(rho_2),
            turning=inverse_root * (turned - dot(normal, A * turned) / rho_2 * normal),
            poles=moments,
            weights=tuple(1 / gap for gap in gaps(moments)),
            leading=2 * h,
            roots=(*moments, (trace - spread) / 2, (trace + spread) / 2),
            speeds=(sp.S.Zero, 2 / sp.sqrt(det)),
            time_rescaling=rho,
            state=(
                (omega, rho * sp.sqrt(det) * (inverse_root * cross(nu, nuprime))),
                (normal, rho * (root * nu)),
            ),
            source="§9.5",
        )
    )


def of_ratio() -> SeparatedSystem:
    """The family of balls in k and J, at k = −1."""
    family = from_catalogue("rubber-ball-of-ratio", k=-1.0)
    return _separation_hollow(
        "rubber-ball-of-ratio", family, n, rubber_ball_ratio.J.symbols, rubber_ball_ratio.k + 1
    )


def on_e3() -> SeparatedSystem:
    """The Hamiltonian form (9.14) on e(3), at k = −1, with γ = ν."""
    system = from_catalogue("rubber-ball-on-e3", k=-1.0)
    moments = rubber_ball_ratio.J.symbols
    det = sp.Mul(*moments)
    J, A = (_tensor(moments, sp.Integer(power)) for power in (1, -1))
    stiffness = dot(gamma, J * gamma)
    known = of_ratio()
    separable = replace(
        known,
        name="rubber-ball-on-e3",
        title="Hollow rubber ball around a sphere of half its radius, on e(3)",
        system=system,
        constants=(
            (h, norm_squared(M) / (2 * det * stiffness)),
            (F, dot(M, J * M) / det + norm_squared(M) * dot(gamma, A * gamma) / stiffness),
        ),
        direction=gamma,
        turning=cross(gamma, M) / det,
        time_rescaling=dot(nu, J * nu),
        state=((M, -det * cross(nu, nuprime)), (gamma, nu)),
        source="§9.3, (9.14)",
    )
    return with_laws(separable)


def on_plane() -> SeparatedSystem:
    """The family of balls in k and J, at k = 1."""
    family = from_catalogue("rubber-ball-of-ratio", k=1.0)
    moments = dict(zip(veselova.I.symbols, rubber_ball_ratio.J.symbols, strict=True))
    separable = replace(
        in_symbols_of(without_field(), family, moments),
        name="rubber-ball-on-plane",
        title="Rubber ball on a plane",
        level=(rubber_ball_ratio.k - 1,),
        source="§9.2, Remark 16",
    )
    return with_laws(separable)


def hollow_ball(system: System | None = None) -> SeparatedSystem:
    """A hollow ball around a sphere of half its radius, R = 2a.

    Parameters
    ----------
    system : System, optional
        A rubber ball around a sphere with the names of the catalogue's, which is the default.
    """
    ball = from_catalogue("rubber-ball-around-sphere") if system is None else system
    m, R, a = (real_symbol(s) for s in ("m", "R", "a"))
    first, second, third = (real_symbol(f"I_{i}") + m * R**2 for i in (1, 2, 3))
    return _separation_hollow(
        "rubber-ball-around-sphere", ball, gamma, (first, second, third), R - 2 * a
    )
