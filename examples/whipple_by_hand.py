"""Linear equations of the Whipple bicycle as derived by hand.

Meijaard, Papadopoulos, Ruina, Schwab, Proc. R. Soc. A 463 (2007), Appendix A: the matrices of small
lean and steering angles about straight upright running.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath


def by_hand(p: Mapping[str, Any], speed: Any) -> list[Any]:
    """Eigenvalues of M q̈ + v C₁ q̇ + (g K₀ + v² K₂) q = 0, q = (lean, steer), as published.

    `p` gives the parameters of the machine by name, as numbers of mpmath.
    """
    w, c, g, cl, sl = p["w"], p["c"], p["g"], mpmath.cos(p["lambda"]), mpmath.sin(p["lambda"])
    # mass, place and inertia tensor (xx, xz, zz) of rear wheel, frame, fork and front wheel
    bodies = {
        "R": (p["m_R"], 0, -p["R_R"], p["I_Rxx"], 0, p["I_Rxx"]),
        "B": (p["m_B"], p["x_B"], p["z_B"], p["I_Bxx"], p["I_Bxz"], p["I_Bzz"]),
        "H": (p["m_H"], p["x_H"], p["z_H"], p["I_Hxx"], p["I_Hxz"], p["I_Hzz"]),
        "F": (p["m_F"], w, -p["R_F"], p["I_Fxx"], 0, p["I_Fxx"]),
    }

    def together(names: str, x: Any, z: Any) -> list[Any]:
        """The inertia tensor of several bodies about the point (x, z)."""
        parts = [bodies[name] for name in names]
        return [
            mpmath.fsum(xx + m * (b - z) ** 2 for m, a, b, xx, xz, zz in parts),
            mpmath.fsum(xz - m * (a - x) * (b - z) for m, a, b, xx, xz, zz in parts),
            mpmath.fsum(zz + m * (a - x) ** 2 for m, a, b, xx, xz, zz in parts),
        ]

    def centre(names: str) -> tuple[Any, Any, Any]:
        """Mass and place of the centre of mass of several bodies."""
        parts = [bodies[name] for name in names]
        mass = mpmath.fsum(part[0] for part in parts)
        return (mass, *(mpmath.fsum(q[0] * q[i] for q in parts) / mass for i in (1, 2)))

    m_T, x_T, z_T = centre("RBHF")
    m_A, x_A, z_A = centre("HF")
    T_xx, T_xz, T_zz = together("RBHF", 0, 0)
    A_xx, A_xz, A_zz = together("HF", x_A, z_A)
    u_A = (x_A - w - c) * cl - z_A * sl
    A_ll = m_A * u_A**2 + A_xx * sl**2 + 2 * A_xz * sl * cl + A_zz * cl**2
    A_lx = -m_A * u_A * z_A + A_xx * sl + A_xz * cl
    A_lz = m_A * u_A * x_A + A_xz * sl + A_zz * cl
    mu = c / w * cl
    S_F = p["I_Fyy"] / p["R_F"]
    S_T = S_F + p["I_Ryy"] / p["R_R"]
    S_A = m_A * u_A + mu * m_T * x_T
    mixed = A_lx + mu * T_xz
    mass = mpmath.matrix([[T_xx, mixed], [mixed, A_ll + 2 * mu * A_lz + mu**2 * T_zz]])
    weight = mpmath.matrix([[m_T * z_T, -S_A], [-S_A, -S_A * sl]])
    centrifugal = mpmath.matrix([[0, (S_T - m_T * z_T) * cl / w], [0, (S_A + S_F * sl) * cl / w]])
    turning = mu * S_T + S_F * cl
    damping = mpmath.matrix(
        [
            [0, turning + T_xz * cl / w - mu * m_T * z_T],
            [-turning, A_lz * cl / w + mu * (S_A + T_zz * cl / w)],
        ]
    )
    speed = mpmath.mpf(str(speed))
    stiffness = mass**-1 * (g * weight + speed**2 * centrifugal)
    friction = mass**-1 * (speed * damping)
    first_order = mpmath.matrix(4, 4)
    for i in range(2):
        first_order[i, i + 2] = 1
        for j in range(2):
            first_order[i + 2, j] = -stiffness[i, j]
            first_order[i + 2, j + 2] = -friction[i, j]
    return list(mpmath.eig(first_order)[0])
