"""Zero normal force of a rolling body, and its acceleration without the support.

The touching particle of a body without slip has the acceleration b + A R with the reaction R, where
b is its acceleration in free motion.  Rolling needs R = −A⁻¹b.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.system.laws import Identity
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Symmetric, real_symbol, vectors

A, (b, reaction) = Symmetric("A"), vectors("b reaction")
x = real_symbol("x")


@dataclass(frozen=True)
class LoadedBall:
    """A ball that rolls on a plane at one moment; its inertia is that of a sphere.

    Attributes
    ----------
    mass, moment, radius, gravity : sympy.Rational
    centre, gamma, omega : sympy.Matrix
        Centre of the sphere, normal and angular velocity, body axes.
    """

    mass: sp.Rational
    moment: sp.Rational
    radius: sp.Rational
    gravity: sp.Rational
    centre: sp.Matrix
    gamma: sp.Matrix
    omega: sp.Matrix

    @property
    def r(self) -> sp.Matrix:
        """From the centre of mass to the contact."""
        return self.centre - self.radius * self.gamma

    def mobility(self) -> sp.Matrix:
        """A = E/m − r̂ I⁻¹ r̂."""
        r = self.r
        return sp.eye(3) / self.mass + (r.dot(r) * sp.eye(3) - r * r.T) / self.moment

    def free_acceleration(self) -> sp.Matrix:
        """b, of the touching particle along the contact, without support."""
        r, omega, gamma = self.r, self.omega, self.gamma
        wandering = -self.radius * gamma.cross(omega)
        along = omega.cross(omega.cross(r)) + omega.cross(wandering)
        return -self.gravity * gamma + along

    def reaction(self) -> sp.Matrix:
        """The force with which the plane keeps the ball rolling."""
        return -(self.mobility().inv() * self.free_acceleration())

    @property
    def normal_force(self) -> sp.Rational:
        """The normal component of the reaction."""
        return self.gamma.dot(self.reaction())

    @property
    def free_rise(self) -> sp.Rational:
        """The acceleration of the contact along the normal without support."""
        return self.gamma.dot(self.free_acceleration())


#: A ball of mass 1, moment 1/5 and radius 1 with its centre of mass 7/10 off the centre.
WITHOUT_FORCE = LoadedBall(
    mass=sp.Integer(1),
    moment=sp.Rational(1, 5),
    radius=sp.Integer(1),
    gravity=sp.Rational(105, 328),
    centre=sp.Matrix([0, 0, sp.Rational(7, 10)]),
    gamma=sp.Matrix([sp.Rational(3, 5), 0, sp.Rational(4, 5)]),
    omega=sp.Matrix([-1, 0, -1]),
)


def any_contact() -> System:
    """A contact with arbitrary A and b, the normal along the third axis, and R = −A⁻¹b."""
    numbers = (
        *((s, 2.0 if str(s)[-1] == str(s)[-2] else 0.3) for s in A.symbols),
        *((s, 0.7 - i) for i, s in enumerate(b.symbols)),
    )
    return System(
        name="any-contact",
        title="A contact without slip",
        field={x: sp.S.Zero},
        definitions={reaction: -1 * (A**-1 * b)},
        parameters=tuple(Parameter(s, "mobility or acceleration", value) for s, value in numbers),
    )


def zero_normal_acceleration() -> Identity:
    """Identity B N + b_n = 0: the friction needed for rolling leaves no normal acceleration.

    With friction in this direction, at the coefficient |f|/|N|, the normal acceleration per unit
    of normal force is B = A_nn + (A_nt, f)/N.
    """
    f_1, f_2, N = reaction.symbols
    entries = A.entries
    response = entries[2, 2] + (entries[2, 0] * f_1 + entries[2, 1] * f_2) / N
    return Identity("paradox", response * N + b.symbols[2], "B = −b_n/N")
