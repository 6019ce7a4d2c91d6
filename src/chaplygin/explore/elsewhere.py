"""What is proven of the systems onto which proven isomorphisms carry a system.

Functions that are constant there are constant here.  A Hamiltonian form there is one here, up to the
change of time, where the map is a local diffeomorphism and the parameters of the target are numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from ..laws.errors import OutOfReachError
from ..laws.residuals import components
from ..statements import Isomorphism, Law, Measure
from .forms import density, hamiltonian
from .hierarchy import Bracket, Density
from .proofs import Fact, Patience
from .sign import sign
from .sorting import sorted_laws
from .sources import Source, carried, sources
from .standing import Standing, View

__all__ = ["There", "followed"]

#: Isomorphisms that are followed one after another.
DEPTH = 2


@dataclass(frozen=True)
class There:
    """What the targets of isomorphisms give."""

    sources: tuple[Source, ...] = ()
    brackets: tuple[Bracket, ...] = ()
    liouville: tuple[Fact, ...] = ()
    measures: tuple[Density, ...] = ()


def followed(
    standing: Standing, laws: Sequence[Law], patience: Patience, depth: int = DEPTH
) -> There:
    """What is proven of the targets of the isomorphisms among some proven laws.

    Parameters
    ----------
    standing : Standing
    laws : sequence of Law
        Proven on it.
    patience : Patience
        For the proofs of the laws of the targets.
    depth : int
        How many isomorphisms may follow one another.
    """
    found = There()
    for law in laws:
        if isinstance(law, Isomorphism) and depth:
            more = _through(standing, law, patience, depth)
            found = There(
                found.sources + more.sources,
                found.brackets + more.brackets,
                found.liouville or more.liouville,
                found.measures or more.measures,
            )
    return found


def _through(standing: Standing, law: Isomorphism, patience: Patience, depth: int) -> There:
    target = law.target
    values = _constants(standing, law)
    if values is None:
        plain = [each for each in target.laws if not each.on and patience.verdict(target, each)]
        return There(tuple(carried(law, source) for source in sources(plain)))
    there = Standing(target, values=values)
    laws = sorted_laws(there, patience.verdicts(target)).general
    beyond = followed(there, laws, patience, depth - 1)
    constant = tuple(carried(law, s) for s in (*sources(laws), *beyond.sources))
    if not _diffeomorphic(standing, there, law):
        return There(constant)
    forms = hamiltonian(there, laws, patience)
    measures = tuple(density(there, each) for each in laws if isinstance(each, Measure))
    return There(
        constant,
        tuple(_bracket(standing, law, b) for b in forms.brackets + beyond.brackets),
        tuple(_fact(law, fact) for fact in forms.liouville or beyond.liouville),
        tuple(Density(_fact(law, m.law), "unknown") for m in measures or beyond.measures),
    )


def _fact(law: Isomorphism, fact: Fact) -> Fact:
    return Fact(law.name, fact.words, fact.source, fact.system or law.target.title)


def _bracket(standing: Standing, law: Isomorphism, bracket: Bracket) -> Bracket:
    """A Hamiltonian form of the target as one of the system itself."""
    timed = law.time != 1
    kept = sign(standing, [law.time]) if timed else "kept"
    both = bracket.sign if kept == "kept" else kept
    return replace(
        bracket,
        law=_fact(law, bracket.law),
        casimirs=(),
        conformal=bracket.conformal or timed,
        sign=both,
    )


def _constants(standing: Standing, law: Isomorphism) -> dict[sp.Symbol, sp.Rational] | None:
    """The parameters of the target as rational numbers; None where they depend on the state."""
    named = dict(components(law.constants, standing.ground))
    formulas = {p.symbol: named.get(p.symbol, p.symbol) for p in law.target.parameters}
    state = set(standing.system.symbols)
    if any(standing.expanded(f).free_symbols & state for f in formulas.values()):
        return None

    def numbers(view: View) -> dict[sp.Symbol, Any]:
        values = {s: view.jet(f).value for s, f in formulas.items()}
        return values if view.field.exact else {}

    found = standing.at_points(numbers)[0]
    if len(found) != len(formulas):
        return None
    return {s: sp.Rational(int(x.p), int(x.q)) for s, x in found.items()}


def _diffeomorphic(standing: Standing, there: Standing, law: Isomorphism) -> bool:
    """Whether the map has an inverse near almost every point."""
    try:
        if standing.dimension != there.dimension:
            return False
        images = list(components(law.map, standing.ground).values())
        size = len(standing.system.symbols)
        return standing.full(
            size, lambda view: [*standing.bounds(view), *map(view.differential, images)]
        )
    except OutOfReachError:
        return False
