"""Measures whose density depends on the configuration alone: found, or shown not to exist."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass, replace

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.errors import OutOfReachError
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.printing.formula import text
from flowlanes.system.vectors import real_symbol

from ..invariant_measures.existence import invariant_measure
from ..invariant_measures.result import MeasureExistence
from ..mechanics.lagrangian.mechanism import Mechanism
from ..mechanics.rolling.equations import RollingBody
from .facts import HERE, Fact, ProofBudget
from .ranks import Number
from .statements import Density

_OPEN = "whether one has a density that depends on the configuration alone"


@dataclass(frozen=True)
class MeasureFacts:
    """Results on measures with a density on the configuration space.

    Attributes
    ----------
    measures : tuple of Density
        The measure, if there is one.
    absence : str
        Proof that there is none, with the witness; empty otherwise.
    open : str
        A statement that neither is known; empty otherwise.
    """

    measures: tuple[Density, ...] = ()
    absence: str = ""
    open: str = ""


def configuration_measure(
    source: RollingBody | Mechanism | None, budget: ProofBudget
) -> MeasureFacts:
    """Decide whether a model preserves a measure with a density on the configuration space.

    Parameters
    ----------
    source : RollingBody or Mechanism, optional
        The mechanical model with its numbers; without it there is no result.  The parameters of a
        mechanism have their present values, as exact decimals.
    budget : ProofBudget
    """
    if source is None:
        return MeasureFacts()
    if budget.over:
        return MeasureFacts(open=f"{_OPEN} was not tried")
    budget.progress("a measure whose density depends on the configuration alone")
    try:
        model = _at_present(source) if isinstance(source, Mechanism) else source
        existence = invariant_measure(model, effort=budget.effort)
    except (InputError, OutOfReachError, ZeroDivisionError):
        return MeasureFacts(open=f"{_OPEN} is undecided")
    budget.effort_used += sum(verdict.effort for verdict in existence.verdicts)
    if existence.decision == "none":
        return MeasureFacts(absence=_witness(existence))
    if existence.decision == "undecided":
        return MeasureFacts(open=f"{_OPEN} is undecided")
    # For a mechanism the density may depend on coordinates that its equations do not contain.
    if existence and isinstance(source, RollingBody):
        return MeasureFacts((Density(_fact(existence), "kept"),))
    return MeasureFacts()


def _at_present(mechanism: Mechanism) -> Mechanism:
    """A mechanism with the present numbers in place of its parameters."""
    values = {p.symbol: exact_number(p.default) for p in mechanism.parameters}
    bare = replace(mechanism, parameters=(), observables=(), guards=(), laws=())
    mechanism_with_numbers: Mechanism = _with_numbers(bare, values)
    return mechanism_with_numbers


def _with_numbers(part: sp.Expr, values: Mapping[sp.Symbol, Number]) -> sp.Expr:
    """Formulas, and objects made of formulas, with symbols replaced by numbers."""
    if isinstance(part, sp.Basic | sp.MatrixBase):
        return part.xreplace(values)
    if isinstance(part, tuple):
        return tuple(_with_numbers(item, values) for item in part)
    if is_dataclass(part) and not isinstance(part, type):
        items = {f.name: getattr(part, f.name) for f in fields(part) if f.init}
        return replace(part, **{n: _with_numbers(item, values) for n, item in items.items()})
    return part


def _fact(existence: MeasureExistence) -> Fact:
    density = "by quadrature" if existence.density is None else text(existence.density.value)
    return Fact("existence", f"density, a function of the normal γ: {density}", HERE)


def _witness(existence: MeasureExistence) -> str:
    """The obstruction to a measure, and the point at which it was found."""
    if not existence.obstruction:
        return existence.reason
    point: dict[str, str] = existence.obstruction["point"]
    shown = {text(real_symbol(name)): _short(value) for name, value in point.items()}
    # For a rolling body only the vertical is printed; the report shows parameters and the rest.
    words = [name for name in shown if "γ" in name] or list(shown)
    place = ", ".join(f"{name} = {shown[name]}" for name in words)
    what = str(existence.obstruction["what"])
    return f"{what}, as at {place}" if place else what


def _short(value: str) -> str:
    """A ball by its midpoint with six digits; an exact number unchanged."""
    middle, ball, _ = value.strip("[]").partition(" +/-")
    return f"{float(middle):.6g}" if ball else value
