"""The place of a system in the hierarchy of dynamics (§3, §4).

What is proven of a system tells what its motions can be.

A place is built on verdicts alone.  What is undecided or refuted does not count, and is named; what
holds on a level counts on that level; what holds for special parameters counts where the present
ones satisfy the condition exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ...arguments import arguments_checked
from ...core.system import System
from ...mechanics.lagrangian.mechanism import Mechanism
from ...mechanics.rolling.equations import Rolling
from ...proof.fields.budget import EFFORT
from ...proof.verdict import Verdict
from .facts import Fact, Patience

__all__ = ["Bracket", "Density", "Kind", "Place", "Statement", "Uncounted", "place", "standing_of"]

#: Term operations for the proof of one law, and for all, where the place must be there at once.
PATIENCE = EFFORT // 50
ALTOGETHER = EFFORT // 25


@dataclass(frozen=True)
class Statement:
    """A sentence with the facts on which it rests."""

    text: str
    by: tuple[Fact, ...] = ()


@dataclass(frozen=True)
class Kind:
    """A class of systems to which this one belongs.

    Attributes
    ----------
    name : str
        ``"curves"``, ``"lie"``, ``"euler-jacobi"``, ``"liouville"``, ``"hamiltonian"``,
        ``"conformally hamiltonian"`` or ``"none known"``.
    text : str
        What that means here.
    by : tuple of Fact
    """

    name: str
    text: str
    by: tuple[Fact, ...] = ()


@dataclass(frozen=True)
class Density:
    """An invariant measure: its law, and whether its density stays positive and finite.

    `sign` is ``"kept"`` where that is shown everywhere, ``"changes"`` where the density vanishes
    or is infinite somewhere, ``"unknown"`` where neither is decided.
    """

    law: Fact
    sign: str


@dataclass(frozen=True)
class Bracket:
    """A (conformally) Hamiltonian form.

    Attributes
    ----------
    law : Fact
    rank : int
        Of the Poisson structure, at a generic point of the level.
    casimirs : tuple of str
        Casimir functions that are proven, besides the relations of the phase space.
    closed : bool
        Whether these are all, so that the symplectic leaves are their common levels (§3.4).
    conformal : bool
        Whether the form needs a reducing multiplier, a change of time.
    sign : str
        As for `Density`, of the multiplier.
    """

    law: Fact
    rank: int
    casimirs: tuple[str, ...]
    closed: bool
    conformal: bool
    sign: str


@dataclass(frozen=True)
class Uncounted:
    """A law that does not count, and why."""

    law: str
    why: str


@dataclass(frozen=True)
class Place:
    """The place of a system, or of one of its levels, in the hierarchy of dynamics.

    Attributes
    ----------
    system : str
        Its title.
    level : str
        In words, empty for the whole phase space.
    variables, conditions : int
        Number of state variables, and rank of the conditions between them.
    integrals : tuple of Fact
        Independent first integrals.
    count : int
        How many functions these are: a reduction to linear equations gives several.
    dependent : tuple of Fact
        Further integrals, functions of the others as far as the rank tells.
    measures : tuple of Density
    absence : str
        Why there is no measure whose density depends on the configuration alone, if that is shown.
    brackets : tuple of Bracket
    symmetries : tuple of Fact
        Fields that commute with the motion and are independent of it and of one another.
    reversal : tuple of str
        Variables whose change of sign makes the motion run backwards in time; looked for where
        no measure excludes attracting sets.
    reductions : tuple of Fact
        Further proven reductions, separations, isomorphisms.
    kinds : tuple of Kind
    dynamics : tuple of Statement
        What its motions can be.
    uncounted : tuple of Uncounted
    levels : tuple of Place
        Levels on which more is proven.
    reason : str
        Why nothing could be counted; empty where it could.
    """

    system: str
    level: str
    variables: int
    conditions: int
    integrals: tuple[Fact, ...] = ()
    count: int = 0
    dependent: tuple[Fact, ...] = ()
    measures: tuple[Density, ...] = ()
    absence: str = ""
    brackets: tuple[Bracket, ...] = ()
    symmetries: tuple[Fact, ...] = ()
    reversal: tuple[str, ...] = ()
    reductions: tuple[Fact, ...] = ()
    kinds: tuple[Kind, ...] = ()
    dynamics: tuple[Statement, ...] = ()
    uncounted: tuple[Uncounted, ...] = ()
    levels: tuple[Place, ...] = ()
    reason: str = ""

    @property
    def dimension(self) -> int:
        """Of the phase space, or of the level."""
        return self.variables - self.conditions

    @property
    def remaining(self) -> int:
        """Dimension of a common level of the integrals."""
        return self.dimension - self.count

    @property
    def uncounted_by_reason(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Why laws do not count, each reason with the names of the laws."""
        found: dict[str, tuple[str, ...]] = {}
        for entry in self.uncounted:
            found[entry.why] = (*found.get(entry.why, ()), entry.law)
        return tuple(found.items())

    @property
    def record(self) -> dict[str, Any]:
        """Everything, ready for JSON."""
        from .text import record

        return record(self)

    def __str__(self) -> str:
        from .text import told

        return told(self)


@arguments_checked
def place(
    system: System,
    verdicts: Mapping[str, Verdict] | None = None,
    patience: Patience | None = None,
    given: Rolling | Mechanism | None = None,
) -> Place:
    """The place of a system in the hierarchy of dynamics.

    Parameters
    ----------
    system : System
        Its parameters count with their present values (their defaults), taken as exact decimals.
    verdicts : mapping of str to Verdict
        On its laws, by name; a law without a verdict does not count.  By default what can
        be proven with `patience`.
    patience : Patience, optional
        For the proofs needed besides: that symmetries leave the integrals alone, that integrals
        are in involution, laws of the targets of isomorphisms, laws restricted to a level.
    given : Rolling or Mechanism, optional
        What moves, with its numbers.  Where no measure is proven of its equations, it is then
        decided whether there is one whose density depends on the configuration alone.

    Returns
    -------
    Place
    """
    # the parts are built from the values that this module declares
    from .classifier import counted

    patience = patience or Patience(PATIENCE, ALTOGETHER)
    known = patience.verdicts(system) if verdicts is None else verdicts
    return counted(system, known, patience, given)


def standing_of(system: System, given: Rolling | Mechanism | None = None) -> Place:
    """The place of a system by what can be proven with little effort, in a few seconds."""
    return place(system, given=given)
