"""§4.3: gyroscopic forces."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System

from ..claim import Case, Claim, Remark
from ..methods.unspecified_systems import system, unspecified_functions
from .section_04_3 import new_time_motion, q, u

W = unspecified_functions("W1 W2", *q)
TURN = sp.diff(W[1], q[0]) - sp.diff(W[0], q[1])


def euler_lagrange() -> Case:
    """The Lagrange–Euler equations of L̄ + W are those of L̄ with S̄ = ∂W₂/∂q₁ − ∂W₁/∂q₂."""
    barred = sp.Function("L")(*q, *u)
    whole = barred + W[0] * u[0] + W[1] * u[1]

    def left(function: sp.Expr, i: int) -> sp.Expr:
        return Rate(sp.diff(function, u[i])) - sp.diff(function, q[i])

    other = (u[1] * TURN, -u[0] * TURN)
    residuals = tuple(left(whole, i) - (left(barred, i) - other[i]) for i in range(2))
    return new_time_motion(), Identity("euler_lagrange", residuals)


def canonical_momenta() -> Case:
    """With {p₁, p₂} = S̄ of (4.6) the brackets of q_i, p̃_i = p_i + W_i are canonical."""
    p = sp.symbols("p_1:3", real=True)
    state = (*q, *p)
    magnetic = sp.zeros(4)
    magnetic[0:2, 2:4], magnetic[2:4, 0:2] = sp.eye(2), -sp.eye(2)
    magnetic[2, 3], magnetic[3, 2] = TURN, -TURN
    new = sp.Matrix([*q, p[0] + W[0], p[1] + W[1]])
    slopes = new.jacobian(state)
    canonical = sp.zeros(4)
    canonical[0:2, 2:4], canonical[2:4, 0:2] = sp.eye(2), -sp.eye(2)
    dynamics = system("phase_space", "T*M", dict.fromkeys(state, sp.S.Zero))
    difference = slopes * magnetic * slopes.T - canonical
    return dynamics, Identity("canonical", tuple(difference))


# --- exactness -----------------------------------------------------------------------------

(psi,) = unspecified_functions("Psi", *q)


def on_torus() -> tuple[System, Identity]:
    """Ω = dω on the torus if S̄ = g′(q₂) + ∂Ψ/∂q₁ with periodic g and Ψ.

    g′ is the mean of S̄ over q₁, and ∂Ψ/∂q₁ is the rest, whose mean vanishes, so that a periodic Ψ
    exists. A periodic g exists if and only if the mean of g′, the integral of Ω, vanishes.
    """
    (mean,) = unspecified_functions("g", q[1])
    spread = sp.diff(mean, q[1]) + sp.diff(psi, q[0])
    return _closedness("torus", (-mean, psi), spread)


def on_sphere() -> tuple[System, Identity]:
    """Ω = dω on the sphere, q = (θ, φ), when S̄ = g′(θ) + sin θ ∂Ψ/∂φ, where ω = g dφ − Ψ sin θ dθ.

    With Ω = f times the area form, g′ is sin θ times the mean of f over φ, and Ψ is the periodic
    primitive of the remainder, which has no mean: in each harmonic exp(imφ) it is f/(im), as
    smooth at the poles as f. g = ∫g′ dθ from one pole vanishes there like θ², and at the other
    pole, as g dφ requires, if and only if the integral of Ω vanishes.
    """
    (mean,) = unspecified_functions("g", q[0])
    spread = sp.diff(mean, q[0]) + sp.sin(q[0]) * sp.diff(psi, q[1])
    return _closedness("sphere", (-psi * sp.sin(q[0]), mean), spread)


def _closedness(
    name: str, potential: tuple[sp.Expr, sp.Expr], spread: sp.Expr
) -> tuple[System, Identity]:
    """∂ω₂/∂q₁ − ∂ω₁/∂q₂ = S̄."""
    dynamics = system(name, name, dict.fromkeys(q, sp.S.Zero))
    curl = sp.diff(potential[1], q[0]) - sp.diff(potential[0], q[1])
    return dynamics, Identity("exact", curl - spread)


def exact() -> Case:
    """The potentials on the torus and on the sphere; their necessity is Stokes' theorem."""
    return on_torus(), on_sphere()


CLAIMS = (
    Claim(
        "§4.3, Lagrange–Euler equations",
        r"With $\Omega = \bar S\,dq_1\wedge dq_2 = d\omega$, $\omega = W_1 dq_1 + W_2 dq_2$, the "
        r"equations are the Lagrange–Euler equations of $L_W = \bar L + W_1 q'_1 + W_2 q'_2$",
        euler_lagrange,
        note="for any L̄ and W",
    ),
    Claim(
        "§4.3, canonical momenta",
        r"Using new momenta $\tilde p_i = p_i + W_i(\mathbf{q})$, the Poisson bracket (4.6) is "
        "reduced to the canonical form",
        canonical_momenta,
    ),
    Claim(
        "§4.3, exactness",
        "If the manifold on which $q_1$ and $q_2$ are defined is compact, then the form Ω is "
        r"exact iff $\int_{\mathcal{M}}\Omega = 0$",
        exact,
        note="on a disk, whose boundary is part of it, "
        r"$\Omega = dq_1\wedge dq_2$ is exact and its integral is not zero",
        argument="on every such surface it is de Rham's theorem; computed are the torus and the "
        "sphere, with ω written out",
        where=("the surface is connected, orientable and without boundary",),
    ),
)

REMARKS = (
    Remark(
        "§4.3, end",
        "If Ω is not exact, one speaks of the impossibility of global reduction of the equations "
        "to the Hamiltonian form",
        "read as the canonical form: with the bracket (4.6), which needs Ω alone and no W, the "
        "equations are Hamiltonian globally",
    ),
    Remark(
        "§4.3, after Theorem 6",
        "Systems with the bracket (4.6) frequently occur: charged particles in a magnetic field, "
        "gyroscopic forces; multidimensional generalizations are in [53], one of the "
        "Hamilton–Jacobi method in [54]",
        "literature; the bracket and the Lagrangian with $W$ are claims",
    ),
)
