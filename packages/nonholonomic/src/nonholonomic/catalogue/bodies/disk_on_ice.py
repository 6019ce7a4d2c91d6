"""A heavy disk on smooth ice (§11.3; Kozlov and Kolesnikov [99]).

The disk does not bite the ice, but its sharp edge keeps the velocity of the contact point parallel
to the horizontal diameter ξ: the disk may slip and turn about its axis freely.  With the axis e₃,
the direction y up the disk and ξ = y×e₃, so that γ = s y + γ₃ e₃, the contact point is r = −R y,

    v = V ξ + R ω_ξ e₃,

and the reaction N, in the plane of y and e₃, is perpendicular to ξ.  The torque r×N is τ ξ with
τ = −R (N, e₃), and Newton's equation gives both V̇ = −R ω_ξ ω_y and (N, e₃).
"""

from __future__ import annotations

import sympy as sp

HALF = sp.Rational(1, 2)
MOMENTUM = "kg m^2/s"


# --- the disk on ice -----------------------------------------------------------------------
