"""The hollow ball around a sphere of half its radius, k = −1, separated (§8.3).

I is the tensor about the centre, d = mR², J = I + d, I_Q = J − d n⊗n with the normal n of the
sphere.  The tensor of the linear integral (AM, n) has A_i = ½T − I_i with T = ΣI + d; for a rigid
body 2A_i = I_j + I_k − I_i + d > 0.  Where (AM, n) = 0, the unit vector ν = n has

    n_i² = κ (I_i − z₁)(I_i − z₂)/(A_i² I_i Π_i),         Π_i = ∏_{j≠i}(I_i − I_j),

so that z₁, z₂ are the roots of Σ A_i² I_i n_i²/(I_i − z) = 0.  In the time dτ = (det I_Q)^(−1/2) dt

    y² = p(z) L(z) (2hz L(z) − f Q(z)),       p = ∏(I_i − z),
    L = e₂(½T − z) − e₃,       Q = L − d(½T − z)²,
    Σ dz/y = 2 dτ/e₃,       Σ z dz/y = T dτ/e₃,

where e₂, e₃ are the symmetric functions of A, 2h = (M, ω) and f = M².  The state follows by

    ω = Bn×ṅ/(n, Bn),      B = I_Q A,      M = I_Q ω,

and (n, Bn) > 0 for a rigid body.  M is fixed in space; n is not, and is never parallel to M, since
(AM, n) = 0 with A > 0.

L is positive where z lies between the poles, since e₃/e₂ is smaller than each A_i.  So the
quadratic 2hzL − fQ is not positive at the smaller and not negative at the larger of z₁, z₂: its
roots are real on every motion.  Where fd = 2he₂ one of them is at infinity, and the curve of degree
five; where two moments I_i agree, poles do.  h = 0 is rest.

That z₁, z₂ satisfy these equations is proven in ``tests/closed_form/separations``, everything else
by the laws of the separated system itself.
"""

from __future__ import annotations

from collections.abc import Iterable
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
from ...catalogue.ball_on_sphere import ball_on_sphere_equations
from ..genus_two.separation import SeparatedSystem, gaps, nu, nuprime
from ..genus_two.separation_laws import separation_laws

M, omega, gamma = vectors("M omega gamma")
h, f = real_symbol("h"), real_symbol("f")


def _tensor(entries: Iterable[sp.Expr]) -> sp.ImmutableDenseMatrix:
    return constant(sp.diag(*entries))


def _roots(
    half: sp.Expr, d: sp.Expr, A: tuple[sp.Expr, ...]
) -> tuple[sp.Expr, tuple[sp.Expr, ...]]:
    """The leading coefficient and the roots of L (2hzL − fQ); `half` is ½T."""
    first, second, third = A
    e_2, e_3 = first * second + second * third + third * first, first * second * third
    # 2hzL − fQ = top z² + middle z + last
    top = f * d - 2 * h * e_2
    middle = 2 * h * (e_2 * half - e_3) + f * (e_2 - 2 * d * half)
    last = -f * (e_2 * half - e_3 - d * half**2)
    spread = sp.sqrt(middle**2 - 4 * top * last)
    ends = tuple((-middle + sign * spread) / (2 * top) for sign in (1, -1))
    return e_2 * top, (half - e_3 / e_2, *ends)


def _separation(
    name: str,
    system: System,
    normal: Vector,
    inertia: tuple[sp.Expr, ...],
    d: sp.Expr,
    level: tuple[sp.Expr, ...],
) -> SeparatedSystem:
    """A system with state M and `normal`, and ω among its definitions, on its `level`."""
    T = sp.Add(*inertia) + d
    lever = tuple(T / 2 - moment for moment in inertia)
    A = _tensor(lever)
    J, inverse = (_tensor((moment + d) ** power for moment in inertia) for power in (1, -1))
    e_3 = sp.Mul(*lever)

    def clock(n: Vector) -> sp.Expr:
        """(det I_Q)^(1/2)."""
        return sp.sqrt(J.det() * (1 - d * dot(n, inverse * n)))

    def contact_inertia(vector: sp.MatrixExpr) -> sp.MatrixExpr:
        """I_Q u at n = ν."""
        return J * vector - d * dot(nu, vector) * nu

    crossed = contact_inertia(A * nu)
    turning = cross(crossed, nuprime) / (dot(nu, crossed) * clock(nu))
    leading, roots = _roots(T / 2, d, lever)
    separable = SeparatedSystem(
        name=name,
        title="Hollow ball around a sphere of half its radius, at zero linear integral",
        system=system,
        level=level,
        constants=((h, dot(M, omega) / 2), (f, norm_squared(M))),
        direction=normal,
        turning=clock(normal) * cross(omega, normal),
        poles=inertia,
        weights=tuple(
            1 / (a**2 * moment * gap)
            for a, moment, gap in zip(lever, inertia, gaps(inertia), strict=True)
        ),
        leading=leading,
        roots=(*inertia, *roots),
        speeds=(2 / e_3, T / e_3),
        time_rescaling=clock(nu),
        state=((M, contact_inertia(turning)), (normal, nu)),
        fixed=(M,),
        source="§8.3, (8.1)–(8.4)",
    )
    return replace(
        separable, laws=tuple(law for law in separation_laws(separable) if law.name != "separation")
    )


def of_tensor() -> SeparatedSystem:
    """The ball from the tensor A of its linear integral and d, as (8.1) for k = −1, F₂ = 0."""
    d = ball_on_sphere_equations.d
    A = ball_on_sphere_equations.A.symbols
    # tr A = ½T + d
    inertia = tuple(sp.Add(*A) - d - a for a in A)
    return _separation(
        "ball-around-sphere-zero-area",
        ball_on_sphere_equations.vanishing_area(),
        ball_on_sphere_equations.n,
        inertia,
        d,
        (),
    )


def hollow_ball(system: System | None = None) -> SeparatedSystem:
    """A hollow ball around a sphere of half its radius, R = 2a.

    Parameters
    ----------
    system : System, optional
        A ball around a sphere with the names of the catalogue's, which is the default.
    """
    ball = from_catalogue("ball-around-sphere") if system is None else system
    m, R, a = (real_symbol(s) for s in ("m", "R", "a"))
    inertia = tuple(real_symbol(f"I_{i}") for i in (1, 2, 3))
    d = m * R**2
    lever = _tensor((sp.Add(*inertia) + d) / 2 - moment for moment in inertia)
    level = (R - 2 * a, dot(lever * M, gamma))
    return _separation("ball-around-sphere", ball, gamma, inertia, d, level)
