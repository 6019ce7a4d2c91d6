"""Findings on questions that the paper leaves open, keyed by rows of docs/open-problems.md.

Remarks of the audit refer to them. They are checked like claims, and docs/open-problems.md quotes
their statements and decisions.
"""

from __future__ import annotations

from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE, from_catalogue
from nonholonomic.invariant_measures import fluid_theorem

from ..claim import Case, Finding
from . import lifted_bracket
from .lost_integral import integral_of


def _laws(name: str, *kinds: type, dimension: int | None = None) -> tuple[tuple[System, Law], ...]:
    """The laws of given kinds of a catalogue system, with the system."""
    numbers = {} if dimension is None else {"dimension": dimension}
    system = CATALOGUE[name].system(numbers)
    return tuple((system, law) for law in system.laws if isinstance(law, kinds))


def measures_of_several_dimensions() -> Case:
    """The measures of the marble ball and the Veselova system, by theorems for all n."""
    names = ("chaplygin-ball-nd", "veselova-nd")
    return tuple(case for name in names for case in _laws(name, Measure, dimension=4))


def two_constraints() -> Case:
    """Energy and measure, and the angular momentum without a field."""
    system = from_catalogue("two-veselova-constraints")
    return tuple((system, law) for law in system.laws if isinstance(law, Integral | Measure))


FINDINGS = (
    Finding(
        "1b",
        "F = |M + k|² − K det J (γ, J⁻¹γ) is an integral of the Chaplygin ball with rotors k and "
        "Bruns' field K together",
        "refuted",
        lambda: integral_of("Chaplygin ball"),
    ),
    Finding(
        "1f",
        "the Veselova system with rotors and in Bruns' field is conformally Hamiltonian",
        "proven",
        lambda: _laws("veselova-gyrostat-bruns", ConformallyHamiltonian),
    ),
    Finding(
        "1f",
        "F = |(Iω + k)×γ|² − K det I (γ, I⁻¹γ) is an integral of it",
        "refuted",
        lambda: integral_of("Veselova system"),
    ),
    Finding(
        "1g",
        "with two constraints of Veselova there are an integral of the energy and a measure, and "
        "without a field the momentum (Iω + k, γ) is constant",
        "proven",
        two_constraints,
    ),
    Finding(
        "2a",
        "a ball on two equal balls, with rotors and in Bruns' field, is conformally Hamiltonian",
        "proven",
        lambda: _laws("ball-on-two-balls", ConformallyHamiltonian),
    ),
    Finding(
        "lift",
        "the Chaplygin ball or a ball in a ball bearing, P no multiple of the unit tensor, has a "
        "conformally Hamiltonian form of cotangent type on the unreduced system",
        "refuted",
        lifted_bracket.of_cotangent_type,
    ),
    Finding(
        "3",
        "the marble ball and the Veselova system of n dimensions have their measures, for every "
        "operator of inertia and every n",
        "proven",
        measures_of_several_dimensions,
    ),
    Finding(
        "3, level",
        "on the level k = p∧γ the marble ball of a rigid body has a measure and n − 1 quadratic "
        "integrals, for every n",
        "proven",
        lambda: _laws("chaplygin-ball-on-level-nd", Integral, Measure),
    ),
    Finding(
        "3, spheres",
        "the marble and the rubber ball on and in spheres of n dimensions have their measures",
        "proven",
        lambda: (
            *_laws("chaplygin-ball-on-sphere-nd", Measure),
            *_laws("rubber-ball-on-sphere-nd", Measure),
        ),
    ),
    Finding(
        "4",
        "fluid in ellipsoidal cavities keeps the volume of its variables, so that a body with it "
        "has a measure exactly if the equivalent rigid body has one",
        "proven",
        fluid_theorem.lemma,
    ),
)
"""The findings in the order of docs/open-problems.md."""


def findings_of(*keys: str) -> tuple[Finding, ...]:
    """The findings with given keys."""
    return tuple(finding for finding in FINDINGS if finding.key in keys)
