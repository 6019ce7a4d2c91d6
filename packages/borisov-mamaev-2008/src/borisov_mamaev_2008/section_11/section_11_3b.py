"""§11.3: fast rotation under friction, and the disk on ice."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue
from nonholonomic.mechanics.lagrangian.structure_functions import VectorField

from ..claim import Case, Claim, Remark
from ..methods.catalogue_laws import law_named
from ..methods.growth_vector import growth, holonomic_count_verdict

#: Contact point, cosine and sine of the heading, inclination, angle about the axis.
x, y, c, s, theta, phi = (real_symbol(name) for name in ("x", "y", "c", "s", "theta", "phi"))
COORDINATES = (x, y, c, s, theta, phi)


def ice_growth() -> tuple[int, ...]:
    """Dimensions spanned by the motions of the disk on ice and their commutators.

    The contact point moves along the horizontal diameter; heading, inclination and the angle about
    the axis are free.
    """
    fields: tuple[VectorField, ...] = (
        {x: c, y: s},
        {c: -s, s: c},
        {theta: sp.S.One},
        {phi: sp.S.One},
    )
    place = dict.fromkeys(COORDINATES, sp.S.Zero)
    return growth(fields, COORDINATES, place | {c: sp.Rational(3, 5), s: sp.Rational(4, 5)})


def no_holonomic_constraint() -> Verdict:
    """The velocity parallel to the horizontal diameter is a non-integrable constraint."""
    return holonomic_count_verdict(0, ice_growth(), 5)


def disk() -> System:
    """The disk on ice."""
    return from_catalogue("disk-on-ice")


def integrable_disk() -> Case:
    """Four integrals, a measure, a symmetry and the quadrature for the nutation."""
    system = disk()
    return tuple((system, law) for law in system.laws)


def held_by_the_edge() -> Case:
    """A disk that may rotate about its axis keeps that angular velocity."""
    system = disk()
    return system, law_named(system, "spin")


# --- the model of Contensou and Erismann ---------------------------------------------------


def sliding_share() -> sp.Expr:
    """The force for slow sliding v with spin ω, over μN v/(ωa), under Hertzian pressure.

    A point at r slides with v + ω×r; to first order in v, averaged over the angle, its friction
    contributes the fraction v/(2ωr) of the pressure.
    """
    r, a, angle = sp.symbols("r a angle", positive=True)
    pressure = sp.Rational(3, 2) / (sp.pi * a**2) * sp.sqrt(1 - r**2 / a**2)
    total = sp.integrate(sp.integrate(pressure * r, (r, 0, a)), (angle, 0, 2 * sp.pi))
    gained = sp.integrate(sp.cos(angle) ** 2, (angle, 0, 2 * sp.pi)) / r
    force = sp.integrate(sp.simplify(pressure * gained * r), (r, 0, a))
    return sp.simplify(force * a / total)


def proportional_when_spinning_fast() -> Verdict:
    """The coefficient of proportionality is finite and non-zero; the force is odd in v."""
    share = sliding_share()
    holds = share == 3 * sp.pi / 8
    return Verdict(
        "contensou",
        "proven" if holds else "refuted",
        finding=f"for v ≪ ωa the force is {sp.sstr(share)} μN v/(ωa), exactly integrated",
        witness=None if holds else {"share": str(share)},
    )


CLAIMS = (
    Claim(
        "§11.3, end of the paragraph after Remark 24",
        "Simulations show that in the case of fast rotations the Contensou–Erismann frictional "
        "force is proportional to the sliding velocity and is therefore practically the same as "
        "viscous friction.",
        proportional_when_spinning_fast,
        note="read as the first order in $v/(\\omega a)$; the paper draws it from simulations",
        where=("the pressure is that of Hertz on a disk of radius a",),
    ),
    Claim(
        "§11.3, end",
        "The rolling of a disk over a smooth icy surface, where the velocity at the point of "
        "contact is parallel to the horizontal diameter of the disk, is a model with a "
        "non-integrable constraint.",
        no_holonomic_constraint,
    ),
    Claim(
        "§11.3, end",
        "The disk on ice rolls over the surface while it is allowed to rotate about its axis of "
        "symmetry: no reaction turns it about that axis.",
        held_by_the_edge,
        note="read as $\\omega_3 = \\mathrm{const}$",
    ),
    Claim(
        "§11.3, end, [99]",
        "The disk on ice is integrable.",
        integrable_disk,
        note="read as: four integrals, an invariant measure, a symmetry field, and a quadrature "
        "for the nutation with the values of the integrals",
    ),
)

REMARKS = (
    Remark(
        "§11.3, end, [100]",
        "More complicated integrable problems of a disk on ice were found and investigated in "
        "[100].",
        "literature; the problems are not stated. The disk of [99] is decided above",
    ),
)
