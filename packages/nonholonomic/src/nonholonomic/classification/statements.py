"""Statements of a classification, with their supporting facts."""

from __future__ import annotations

from dataclasses import dataclass

from .facts import Fact


@dataclass(frozen=True)
class Statement:
    """A sentence with its supporting facts."""

    text: str
    by: tuple[Fact, ...] = ()


@dataclass(frozen=True)
class IntegrabilityClass:
    """A class of systems to which this one belongs.

    Attributes
    ----------
    name : str
        ``"curves"``, ``"lie"``, ``"euler-jacobi"``, ``"liouville"``, ``"hamiltonian"``,
        ``"conformally hamiltonian"`` or ``"none known"``.
    text : str
        The consequences for this system.
    by : tuple of Fact
    """

    name: str
    text: str
    by: tuple[Fact, ...] = ()


@dataclass(frozen=True)
class Density:
    """An invariant measure and the sign of its density.

    `sign` is ``"kept"`` if this is shown everywhere, ``"changes"`` if the density vanishes or is
    infinite somewhere, and ``"unknown"`` if neither is decided.
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
        Rank of the Poisson structure at a generic point of the level.
    casimirs : tuple of str
        Proven Casimir functions, in addition to the relations of the phase space.
    closed : bool
        Whether the list is complete, so that the symplectic leaves are common levels (§3.4).
    conformal : bool
        Whether the form needs a reducing multiplier, a change of time.
    sign : str
        Sign of the multiplier, as for `Density`.
    """

    law: Fact
    rank: int
    casimirs: tuple[str, ...]
    closed: bool
    conformal: bool
    sign: str


@dataclass(frozen=True)
class IgnoredLaw:
    """A law that does not count, and the reason."""

    law: str
    why: str
