"""Symbols of contact quantities that friction laws and equations of motion share."""

from __future__ import annotations

from flowlanes.system.vectors import Vector, real_symbol

#: Angular velocity, normal of the support, centre of mass to contact point, its rate (body axes).
omega, gamma, r, rdot = (Vector(name) for name in ("omega", "gamma", "r", "rdot"))

#: Velocity of the touching particle over the support (tangential), and its magnitude.
slip, slip_speed = Vector("slip"), real_symbol("slip_speed")

#: Angular velocity about the normal relative to the support, and its sign in a mode that keeps it.
spin, spin_sign = real_symbol("spin"), real_symbol("spin_sign")

#: Angular velocity of rolling, the tangential part of ω, and its magnitude.
rolling, rolling_speed = Vector("rolling"), real_symbol("rolling_speed")

#: γ×(W ε) with the direction ε of W(γ×ω): the couple that resists along the contour.
contour_couple = Vector("contour_couple")

#: Normal force, tangential force of the support on the body, and the couple that holds the spin.
N, friction, holding_couple = real_symbol("N"), Vector("friction"), real_symbol("holding_couple")

#: The tangential vector e for which γ×(W e) is the couple that holds the rolling.
contour_hold = Vector("contour_hold")

#: Speed (m/s) and angular velocity (rad/s) below which logarithmic time is used.
slip_floor, rolling_floor = real_symbol("slip_floor"), real_symbol("rolling_floor")

#: Acceleration of the centre of mass minus ω×v, and ω̇, both without the reaction of the support.
free_acceleration, free_turn = Vector("acceleration"), Vector("angular_acceleration")

#: Acceleration of the touching particle over the support, and rate of the spin, likewise without
#: it.
slip_rate, spin_rate = Vector("slip_rate"), real_symbol("spin_rate")

#: The term (γ̇, u) in the rate of the normal velocity (γ, u).
normal_rate = real_symbol("normal_rate")

#: Force and couple of the support.
reaction, couple = Vector("reaction"), Vector("couple")

#: Velocity of the touching particle in space, rate of the normal, and contact point (body axes).
contact_velocity, gammadot, reach = (
    Vector(name) for name in ("contact_velocity", "gammadot", "reach")
)

#: Centre of mass (space axes), its velocity (body axes), height of the body above the support.
position, v, gap = Vector("position"), Vector("v"), real_symbol("gap")

#: The same height, integrated from the normal velocity, so that low bounces keep their relative
#: accuracy; computed from the position they would be lost in rounding.
height = real_symbol("height")

#: Rate of the normal velocity per unit of normal force, including friction.
normal_response = real_symbol("normal_response")

#: |Ω|, and the velocity with which the contact point wanders over a body that rolls.
spin_speed = real_symbol("spin_speed")
wandering, wandering_speed = Vector("wandering"), real_symbol("wandering_speed")

#: 𝓕 and 𝓜 of the coupled law, from 0 to 1 and from 0 to 3π/16.
F_share, M_share = real_symbol("F_share"), real_symbol("M_share")
