"""A registry of the systems that separate on a curve of genus two.

The system of a motion is recognised by its field, which the catalogue has; only then is its
separation derived.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.system import System

from ..catalogue import from_catalogue
from .base.problem import Problem
from .genus_two.separation import SeparatedSystem


@dataclass(frozen=True)
class SeparationEntry:
    """A separable system of genus two: the location of its code, and the names of its state.

    Attributes
    ----------
    name : str
        The catalogue's system with its field; empty where the catalogue has none.
    state : str
        The vectors of its state.
    letters : str
        For a rolling body, its parameters other than those of the inertia.
    """

    module: str
    function: str
    name: str
    state: str
    letters: str | None = None

    def fits(self, problem: Problem) -> bool:
        """Whether the names of its state are those of the problem."""
        return self.state == " ".join(map(str, problem.system.state))

    def may_be(self, problem: Problem) -> bool:
        """Whether the fields may agree, by the names of the parameters.

        Rolling bodies always use the same letters.
        """
        if problem.rolling is None:
            # Three moments and the letters are given by as many parameters, or by those of a map.
            few = self.letters is not None and 3 + len(self.letters) > len(problem.parameters)
            return not few or any(law.time == 1 for law in problem.system.laws_of(Isomorphism))
        field = {"K"} if problem.rolling.field.potential != 0 else set()
        known = {str(symbol) for symbol in problem.parameters} | field
        return self.fits(problem) and self.letters is not None and set(self.letters) <= known


#: In the order in which they are tried, after those with the letters of a problem.
SEPARABLE = (
    SeparationEntry(
        "rubber_ball_plane", "rubber_ball_plane", "rubber-chaplygin-ball", "omega gamma", "mR"
    ),
    SeparationEntry("rubber_sphere", "on_plane", "rubber-ball-of-ratio", "omega n"),
    SeparationEntry("veselova", "veselova", "veselova", "omega gamma"),
    SeparationEntry("chaplygin_ball", "chaplygin_ball", "chaplygin-ball", "M gamma", "mR"),
    SeparationEntry(
        "chaplygin_ball_area_constant", "chaplygin_area", "chaplygin-ball", "M gamma", "mR"
    ),
    SeparationEntry(
        "rubber_sphere", "hollow_ball", "rubber-ball-around-sphere", "omega gamma", "mRa"
    ),
    SeparationEntry("rubber_sphere", "of_ratio", "rubber-ball-of-ratio", "omega n"),
    SeparationEntry("rubber_sphere", "on_e3", "rubber-ball-on-e3", "M gamma"),
    SeparationEntry("ball_sphere", "hollow_ball", "ball-around-sphere", "M gamma", "mRa"),
    SeparationEntry("ball_sphere", "of_tensor", "", "M n"),
    SeparationEntry("neumann", "neumann_system", "neumann", "M Gamma"),
    SeparationEntry("clebsch", "clebsch_case", "clebsch", "M Gamma"),
    SeparationEntry("fedorov", "fedorov", "chaplygin-ball-fedorov", "K gamma"),
    SeparationEntry("bruns", "veselova_in_bruns_field", "veselova-bruns", "omega gamma"),
    SeparationEntry(
        "bruns", "rubber_ball_in_bruns_field", "rubber-chaplygin-ball-bruns", "omega gamma", "mRK"
    ),
    SeparationEntry(
        "bruns_ball", "chaplygin_ball_in_bruns_field", "chaplygin-ball-bruns", "M gamma", "mRK"
    ),
    SeparationEntry(
        "bruns_sphere", "hollow_ball_in_bruns_field", "ball-around-sphere-bruns", "M gamma", "mRaK"
    ),
)


@lru_cache(maxsize=len(SEPARABLE))
def catalogue_system(place: SeparationEntry) -> System:
    """The system without its separation; its parameters may have other defaults."""
    return from_catalogue(place.name) if place.name else separated_system(place).system


@lru_cache(maxsize=len(SEPARABLE))
def separated_system(place: SeparationEntry) -> SeparatedSystem:
    """The complete separation of a system."""
    module = import_module(f".separations.{place.module}", __package__)
    separable: SeparatedSystem = getattr(module, place.function)()
    return separable
