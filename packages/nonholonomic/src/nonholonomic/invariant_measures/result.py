"""The result on the existence of a measure with a density in the configuration."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.system.laws import Measure
from flowlanes.system.system import System
from lawproof.proof.verdict import Verdict

Outcome = Literal["exists", "none", "conditional", "undecided"]


@dataclass(frozen=True, repr=False)
class MeasureExistence:
    """Whether a smooth measure with a density in the configuration alone exists.

    Attributes
    ----------
    name : str
        Name of the system.
    decision : ``"exists"``, ``"none"``, ``"conditional"`` or ``"undecided"``
        ``"conditional"`` means that a measure exists if one of `conditions` holds.
    density : Measure, optional
        The measure in closed form, a proven law of `system`.
    system : System, optional
        The equations of motion on which `density` is a law.
    domain : tuple of relations
        Conditions under which `density` is proven positive and smooth.
    conditions : tuple of tuples of sympy.Expr
        Levels in the parameters on which a measure exists; on each all expressions vanish.
    complete : bool
        Whether no measure exists outside `conditions`.
    holds : bool
        Whether the default values of the parameters satisfy one of `conditions`.
    obstruction : mapping, optional
        ``point`` at which the 1-form is not closed (or the spin changes the volume), as exact
        numbers or balls, ``what`` fails and by how much (``residual``).
    criterion : str
        A theorem about the family of the system, as a sentence.
    reason : str
        The basis of the decision, or the reason why there is none.
    verdicts : tuple of Verdict
        The proofs.
    log_density : callable, optional
        σ of the density e^σ by quadrature, for a normal γ as three numbers: (σ, bound of its
        error), zero at a fixed point.
    """

    name: str
    decision: Outcome
    density: Measure | None = None
    system: System | None = field(default=None, repr=False)
    domain: tuple[sp.Basic, ...] = ()
    conditions: tuple[tuple[sp.Expr, ...], ...] = ()
    complete: bool = False
    holds: bool = False
    obstruction: Mapping[str, Any] | None = None
    criterion: str = ""
    reason: str = ""
    verdicts: tuple[Verdict, ...] = field(default=(), repr=False)
    log_density: Callable[[Sequence[float]], tuple[float, float]] | None = field(
        default=None, repr=False
    )

    def __bool__(self) -> bool:
        return self.decision == "exists" or (self.decision == "conditional" and self.holds)

    def __repr__(self) -> str:
        return str(self)

    def __str__(self) -> str:
        lines = [f"{self.name}: {_HEADS[self.decision]}"]
        if self.conditions:
            lines.append(self._shown_conditions())
        if self.density is not None:
            lines.append(f"density: {text(self.density.value)}")
            if self.density.level:
                lines.append("where " + _level(self.density.level))
            if self.domain:
                lines.append("positive and smooth where " + ", ".join(map(text, self.domain)))
        elif self.log_density is not None:
            lines.append("density: by quadrature, no closed form was found")
        if self.obstruction:
            point = self.obstruction["point"]
            shown = ", ".join(_coordinate(k, v) for k, v in point.items())
            lines.append(f"{self.obstruction['what']} at {shown}")
        if self.criterion:
            lines.append(f"theorem: {self.criterion}")
        if self.reason:
            lines.append(self.reason)
        return "\n".join(lines)

    def _shown_conditions(self) -> str:
        only = "if and only if" if self.complete else "if"
        return f"it exists {only} " + ", or ".join(_level(level) for level in self.conditions)


_HEADS = {
    "exists": "has a smooth invariant measure whose density depends on the configuration alone",
    "none": "has no smooth invariant measure whose density depends on the configuration alone",
    "conditional": "has an invariant measure whose density depends on the configuration alone "
    "for some values of its parameters",
    "undecided": "undecided whether it has an invariant measure whose density depends on the "
    "configuration alone",
}


def _coordinate(name: str, value: str) -> str:
    """A coordinate of a point; for a ball, six digits of its midpoint."""
    symbol = text(sp.Symbol(name, real=True))
    if not value.startswith("["):
        return f"{symbol} = {value}"
    return f"{symbol} ≈ {float(value.strip('[').split()[0]):.6g}"


def _level(level: tuple[sp.Expr, ...]) -> str:
    return ", ".join(_equation(condition) for condition in level)


def _equation(condition: sp.Expr) -> str:
    """A difference that vanishes as an equation s = n or s = t, if it has this form."""
    left, remainder = condition.as_independent(*condition.free_symbols, as_Add=True)[::-1]
    terms = sp.Add.make_args(left)
    if len(terms) == 1 and terms[0].is_Symbol:
        return f"{text(terms[0])} = {text(-remainder)}"
    plain = [t for t in terms if t.is_Symbol]
    if len(terms) == 2 and len(plain) == 1 and remainder == 0:
        other = condition - plain[0]
        return f"{text(plain[0])} = {text(-other)}"
    return f"{text(condition)} = 0"
