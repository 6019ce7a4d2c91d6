"""The specification and the results of a search."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.system.laws import Integral, Measure, Symmetry
from flowlanes.system.overview import Overview, WithOverview
from flowlanes.system.vectors import real_symbol

from ..proof.fields.budget import EFFORT
from ..proof.verdict import Verdict
from .ansatz import Ansatz
from .phase_space import RestrictedSystem

Kind = Literal["integral", "measure", "symmetry"]
Progress = Callable[[float, str], None]
"""Called with the completed fraction and a description of the next step."""


def no_progress(fraction: float, words: str) -> None:
    """Ignore progress reports."""


@dataclass(frozen=True)
class SearchSpace:
    """The laws of a system among which to search.

    Attributes
    ----------
    stage : RestrictedSystem
        The system with conditions on its parameters and a level.
    ansatz : Ansatz
        Polynomials in momenta and coordinates.
    also : tuple of Ansatz
        Further polynomials for integrals, such as those in ω in addition to M.
    divisors : tuple of sympy.Expr
        Divisors of integrals (one at a time, up to `powers`).
    bases : tuple of sympy.Expr
        Bases of the powers in the density of a measure.
    powers : int
        Largest exponent of a divisor.
    parameter_degree : int
        Largest degree of a coefficient in the parameters.
    effort : int
        Maximum number of term operations for the proof of one law.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> question = lawproof.search.search_space(top)
    >>> question.powers, question.parameter_degree
    (1, 3)
    """

    stage: RestrictedSystem
    ansatz: Ansatz
    also: tuple[Ansatz, ...] = ()
    divisors: tuple[sp.Expr, ...] = ()
    bases: tuple[sp.Expr, ...] = ()
    powers: int = 1
    parameter_degree: int = 3
    effort: int = EFFORT


@dataclass(frozen=True, repr=False)
class SearchResult(WithOverview):
    """A law found by a search.

    Attributes
    ----------
    kind : ``"integral"``, ``"measure"`` or ``"symmetry"``
    law : Integral, Measure, Symmetry or None
        None if it was found only modulo a prime, without a formula.
    verdict : Verdict or None
        The verdict of the prover.
    catalogue_law : str
        The equal law of the catalogue (name, source); empty if there is none.
    remark : str
        Further findings.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> found = next(lawproof.search.integrals(lawproof.search.search_space(top)))
    >>> found
    F₁ = 4 a² + b²: proven
    >>> found.kind, found.verdict.decision
    ('integral', 'proven')
    """

    kind: Kind
    law: Integral | Measure | Symmetry | None
    verdict: Verdict | None
    catalogue_law: str = ""
    remark: str = ""

    @property
    def proven(self) -> bool:
        """True if an exact proof was found."""
        return self.verdict is not None and bool(self.verdict)

    @property
    def formula(self) -> Any:
        """The law as one formula (a tuple of pairs for a symmetry); None if it has none."""
        return getattr(self.law, "value", getattr(self.law, "field", None))

    def overview(self) -> Overview:
        """The law, what the prover says of it, and what else was seen."""
        if self.law is None or self.verdict is None:
            return Overview(f"{self.kind}: only observed, modulo a prime", (("note", self.remark),))
        if self.kind == "symmetry":
            shown = ", ".join(f"{text(name)} ↦ {text(value)}" for name, value in self.formula)
        else:
            name = "ρ" if self.kind == "measure" else text(real_symbol(self.law.name))
            shown = f"{name} = {text(self.formula)}"
        return Overview(
            f"{shown}: {self.verdict.words}",
            (("repeats", self.catalogue_law), ("note", self.remark)),
        )
