"""§4.3: gyroscopic forces."""

from __future__ import annotations

import sympy as sp

from ..statements import Identity, Rate
from .claim import Case, Claim, Remark
from .section_04_3 import new_time_motion, q, u
from .unspecified import of, system

W = of("W1 W2", *q)
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
    made = system("phase_space", "T*M", dict.fromkeys(state, sp.S.Zero))
    difference = slopes * magnetic * slopes.T - canonical
    return made, Identity("canonical", tuple(difference))


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
)

REMARKS = (
    Remark(
        "§4.3, exactness",
        "On a compact manifold the form Ω is exact iff its integral is zero",
        "de Rham's theorem, for a connected orientable surface without boundary",
    ),
    Remark(
        "§4.3, end",
        "If Ω is not exact, one speaks of the impossibility of global reduction of the equations "
        "to the Hamiltonian form",
        "read as the canonical form: with the bracket (4.6), which needs Ω alone and no W, the "
        "equations are Hamiltonian globally",
    ),
)
