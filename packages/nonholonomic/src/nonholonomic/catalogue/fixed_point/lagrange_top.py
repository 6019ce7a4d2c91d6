"""The Lagrange top (§4.1): a heavy symmetric body about a fixed point on its axis.

In Euler angles γ = (sin θ sin φ, sin θ cos φ, cos θ): θ is the nutation, φ the intrinsic rotation
and ψ the precession.  On e(3) the momentum M and the vertical Γ are taken in body axes.
"""

from __future__ import annotations

import sympy as sp

I_1, I_3, P = sp.symbols("I_1 I_3 P", real=True)
theta, phi, psi = sp.symbols("theta phi psi", real=True)
p_phi, p_psi = sp.symbols("p_phi p_psi", real=True)
