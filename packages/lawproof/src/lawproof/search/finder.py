"""Find the laws of one kind: specify the search, run it, prove what it finds."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Literal

from flowlanes.arguments import arguments_checked
from flowlanes.system.system import System

from ..proof.fields.budget import EFFORT
from .integrals import integrals
from .measures import measures
from .request import search_space
from .result import Progress, SearchResult, SearchSpace, no_progress
from .symmetries import symmetries

Laws = Literal["integrals", "measure", "symmetries"]

#: The search for each kind of laws; it gives them one after the other.
SEARCHES: Mapping[str, Callable[[SearchSpace, Progress], Iterator[SearchResult]]] = (
    MappingProxyType({"integrals": integrals, "measure": measures, "symmetries": symmetries})
)


@arguments_checked
def find_laws(
    system: System,
    kind: Laws = "integrals",
    *,
    degree: int = 2,
    gamma_degree: int = 2,
    momenta: str = "",
    coordinates: str = "",
    at: Sequence[str] = (),
    level: Sequence[str] = (),
    divisors: Sequence[str] | None = None,
    bases: Sequence[str] | None = None,
    powers: int = 1,
    parameter_degree: int = 3,
    effort: int = EFFORT,
    progress: Progress = no_progress,
) -> tuple[SearchResult, ...]:
    """Find the laws of a system from its equations alone, and prove them.

    An integral is sought as P/Qˢ with a polynomial P and a divisor Q, the density of a measure as
    a product of powers of the bases, a symmetry as a field with polynomial components.  Laws that
    follow from those found earlier are omitted.

    Parameters
    ----------
    system : System
    kind : "integrals", "measure" or "symmetries"
    degree, gamma_degree : int
        Largest degrees in the momenta and in the coordinates.
    momenta, coordinates : str
        Names of vectors and scalars, and formulas such as ``"log(x)"``, separated by commas; by
        default M and ω, and all that is left of the state.  An angle enters by its sine and
        cosine.
    at : sequence of str
        Conditions on the parameters, such as ``"k = -1"``.
    level : sequence of str
        Formulas that vanish on the level in question, such as ``"M·γ"``.
    divisors : sequence of str, optional
        Formulas by whose powers an integral may be divided; by default those that suggest
        themselves.
    bases : sequence of str, optional
        Formulas of whose powers a density is made; by default those that suggest themselves.
    powers : int
        Largest power of a divisor.
    parameter_degree : int
        Largest degree in the parameters of a coefficient.
    effort : int
        Term operations that the proof of one law may take.
    progress : callable, optional
        Called with the fraction done and what is being done.

    Returns
    -------
    tuple of SearchResult
        Each with the law and the verdict of the prover.

    Raises
    ------
    InputError
        If something in the search is unknown, impossible or too large, or the field is not
        algebraic.

    See Also
    --------
    lawproof.search : the same in steps, with the laws one after the other.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> for found in lawproof.find_laws(top):
    ...     print(found.formula, found.verdict.decision)
    4*a**2 + b**2 proven
    3*a**2 - c**2 proven
    """
    question = search_space(
        system,
        degree=degree,
        gamma_degree=gamma_degree,
        momenta=momenta,
        coordinates=coordinates,
        at=at,
        level=level,
        divisors=divisors,
        bases=bases,
        powers=powers,
        parameter_degree=parameter_degree,
        effort=effort,
    )
    return tuple(SEARCHES[kind](question, progress))
