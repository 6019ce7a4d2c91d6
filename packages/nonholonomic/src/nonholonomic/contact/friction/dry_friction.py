"""Dry friction, which holds a contact up to a limit: at a point, and over a patch."""

from __future__ import annotations

import math
from dataclasses import dataclass

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import norm_squared, real_symbol

from . import contensou
from .friction_law import Coefficient, CoefficientLaw, FrictionLaw, Reaction, coefficient
from .modes import Mode
from .symbols import (
    F_share,
    M_share,
    N,
    friction,
    gamma,
    holding_couple,
    slip,
    slip_floor,
    slip_speed,
    spin,
    spin_sign,
    spin_speed,
)

mu, spin_couple_arm, patch = (real_symbol(name) for name in ("mu", "spin_arm", "patch"))


@arguments_checked
@dataclass(frozen=True)
class Coulomb(FrictionLaw):
    """Dry friction at a point: a force μN against the slip; at rest at most μN.

    Parameters
    ----------
    mu : float
        Coefficient μ ≥ 0; ``inf`` for a contact that never slips.

    Raises
    ------
    InputError
        If μ is negative or not a number.

    Examples
    --------
    >>> from nonholonomic.contact import Coulomb
    >>> Coulomb(0.3).description
    'dry friction, μ = 0.3'
    """

    mu: float

    kind = "coulomb"
    summary = (
        "Dry friction at a point: while the contact slides, the force μN against the slip; "
        "without slip, whatever force holds the contact, up to μN."
    )
    dissipation = ((mu, N, slip_speed),)
    numbers_are_parameters = True
    has_constant_force = True

    def __post_init__(self) -> None:
        if not self.mu >= 0:
            raise InputError(f"mu {self.mu}: it must be a number not below zero, or inf")

    @property
    def description(self) -> str:
        """A description of the law."""
        return f"dry friction, μ = {self.mu:g}"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """μ, where it is finite."""
        if math.isinf(self.mu):
            return ()
        return (coefficient(mu, "coefficient of sliding friction", self.mu, "1"),)

    @property
    def static_mu(self) -> float:
        """μ."""
        return self.mu

    def reaction(self, mode: Mode) -> Reaction:
        """The force −μN u/|u| while the contact slides."""
        return Reaction(p=-mu * slip / slip_speed) if mode.sliding else Reaction()

    @property
    def reaction_at_rest(self) -> Reaction:
        """Zero, since the forces that hold the contact are not included."""
        return Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The slip while sliding; μ²N² − f² while the slip is held."""
        if mode.sliding:
            return (Guard("stick", slip_speed - slip_floor, "sliding ends"),)
        if math.isinf(self.mu):
            return ()
        return (Guard("slip", mu**2 * N**2 - norm_squared(friction), "sliding begins"),)


@arguments_checked
@dataclass(frozen=True)
class SpinFriction(CoefficientLaw):
    """A couple against the spin with constant arm, independent of the slip.

    Parameters
    ----------
    arm : float
        Couple per normal force (m) while the body spins, and its largest value at rest.

    Raises
    ------
    InputError
        If the arm is negative or not finite.

    Examples
    --------
    >>> from nonholonomic.contact import SpinFriction
    >>> SpinFriction(1e-4).description
    'friction against spin, arm 0.0001 m'
    """

    arm: float

    kind = "spin"
    coefficients = (
        Coefficient(
            "arm", spin_couple_arm, "arm of the friction couple against spin", "m", "spin_arm"
        ),
    )
    in_words = "friction against spin, arm {arm:g} m"
    summary = (
        "Friction against spin: a couple about the normal, the arm times N; without spin, "
        "whatever couple holds it, up to this one."
    )
    acts_while = "spinning"
    formula = Reaction(q=-spin_couple_arm * spin_sign * gamma)
    dissipation = ((spin_couple_arm, N, spin_speed),)
    resists_slip = False

    @property
    def spin_arm(self) -> float:
        """The arm."""
        return self.arm

    @property
    def reaction_at_rest(self) -> Reaction:
        """Zero, since the forces that hold the contact are not included."""
        return Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The spin while spinning.

        The distance of the couple from its limit while the spin is held.
        """
        if mode.spinning:
            return (Guard("spin stop", spin_sign * spin, "spinning ends"),)
        margin = spin_couple_arm**2 * N**2 - holding_couple**2
        return (Guard("spin start", margin, "spinning begins"),)


@arguments_checked
@dataclass(frozen=True)
class ContensouErismann(FrictionLaw):
    """Dry friction over a round patch of contact with Hertz' pressure.

    Slip and spin share the friction: the force falls with the spin, the couple with the slip.

    Parameters
    ----------
    mu : float
        Coefficient μ > 0, finite.
    patch : float
        Radius of the patch of contact (m), positive.

    Raises
    ------
    InputError
        If a number is not positive and finite.

    Examples
    --------
    >>> from nonholonomic.contact import ContensouErismann
    >>> ContensouErismann(0.3, 5e-4).description
    'dry friction over a patch of radius 0.0005 m, μ = 0.3'
    """

    mu: float
    patch: float

    kind = "contensou"
    summary = (
        "Dry friction over a round patch of contact of radius a with Hertz's pressure: slip "
        "and spin share it, so that the force falls with the spin and the couple with the "
        "slip."
    )
    dissipation = (
        (mu, N, F_share, slip_speed),
        (mu, N, patch, M_share, spin_speed),
    )
    numbers_are_parameters = True
    excludes = {  # noqa: RUF012  (never changed)
        kind: "a patch of contact has its own law of sliding and spinning; it excludes the law "
        f"{kind!r}"
        for kind in ("coulomb", "spin")
    }

    def __post_init__(self) -> None:
        for key, value in (("mu", self.mu), ("patch", self.patch)):
            if not (math.isfinite(value) and value > 0):
                raise InputError(
                    f"{key} {value}: with a patch of contact it must be a positive finite number"
                )

    @property
    def description(self) -> str:
        """A description of the law."""
        return f"dry friction over a patch of radius {self.patch:g} m, μ = {self.mu:g}"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """μ and the radius of the patch."""
        return (
            coefficient(mu, "coefficient of sliding friction", self.mu, "1"),
            coefficient(patch, "radius of the patch of contact", self.patch, "m"),
        )

    @property
    def static_mu(self) -> float:
        """μ; a couple held at the same time reduces the available force."""
        return self.mu

    @property
    def patch_radius(self) -> float:
        """The radius of the patch."""
        return self.patch

    def definitions(self, mode: Mode) -> Pairs:
        """The force and the couple per unit of μN, in the range of the mode."""
        return contensou.definitions(patch, mode) if mode.sliding else ()

    def reaction(self, mode: Mode) -> Reaction:
        """The force −μN𝓕 u/|u| and the couple −μNa𝓜 sgn Ω γ."""
        if not mode.sliding:
            return Reaction()
        return Reaction(
            p=-mu * contensou.force_share * slip,
            q=-mu * patch * contensou.couple_share * gamma,
        )

    @property
    def reaction_at_rest(self) -> Reaction:
        """Zero, since the forces that hold the contact are not included."""
        return Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The slip and spin while moving, the limit set while held, and the range."""
        return contensou.guards(patch, mode, mu)
