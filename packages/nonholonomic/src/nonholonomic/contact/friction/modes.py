"""Contact modes: which relative velocities vary, and which are held at zero."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

#: Ranges of k = |u|/(a|Ω|) in which the coupled law is given by one formula.  The two ranges of a
#: held contact are the parts of its limit set below and above k = 1.
Range = Literal["", "inner", "middle", "outer", "below", "above"]


@dataclass(frozen=True)
class Mode:
    """A contact mode: which relative velocities may be nonzero.

    Attributes
    ----------
    touching : bool
        False in flight.
    sliding : bool
        Whether the touching particle of the body moves over the support.
    spinning : bool
        Whether the body may spin about the normal; false where a couple holds it.
    rolling : bool
        Whether the body may roll; false where resistance to rolling holds it.
    range : str
        The range of the coupled law of Contensou and Erismann, empty for other laws.

    Examples
    --------
    >>> from nonholonomic.contact.friction.modes import Mode
    >>> Mode(sliding=False).name
    'rolling'
    """

    touching: bool = True
    sliding: bool = True
    spinning: bool = True
    rolling: bool = True
    range: Range = ""

    @property
    def name(self) -> str:
        """A description of the mode."""
        if not self.touching:
            return "flight"
        if self.rolling:
            name = "sliding" if self.sliding else "rolling"
            return name if self.spinning else f"{name} without spin"
        if self.sliding:
            return "sliding without rolling" if self.spinning else "sliding without turning"
        return "spinning" if self.spinning else "rest"


FLIGHT = Mode(touching=False)

#: All modes by name, in the order of their flags in a dataset.
MODE_NAMES = (
    "flight",
    "sliding",
    "sliding without spin",
    "rolling",
    "rolling without spin",
    "rest",
    "sliding without rolling",
    "sliding without turning",
    "spinning",
)
