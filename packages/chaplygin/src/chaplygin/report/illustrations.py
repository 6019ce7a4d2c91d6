"""The graphical parts of a study's page: figures, the closed form, a diagram."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..experiment.closed_form import ClosedFormSection
from ..page.scene_model import Json


@dataclass(frozen=True)
class Illustrations:
    """The figures of a page, and the section on the closed form.

    Attributes
    ----------
    pairs : mapping of str to (str, str)
        Figures by name, as SVG for wide and for narrow screens.
    letters : str
        The shapes of all letters in them.
    closed : ClosedFormSection, optional
        The section on the closed form, if one is known.
    diagram : JSON
        The bifurcation diagram for the live page, if the system has one.
    """

    pairs: Mapping[str, tuple[str, str]]
    letters: str
    closed: ClosedFormSection | None
    diagram: Json
