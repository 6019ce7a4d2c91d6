"""A reduction as a page for a terminal."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from typing import TYPE_CHECKING

import sympy as sp

from ...printing.formula import text
from .multiplier import poles

if TYPE_CHECKING:
    from .chaplygin import ChaplyginForm

__all__ = ["page"]

WIDTH = 100
MARGIN = 16
LONG = 30
BY_QUADRATURE = (
    "ln N = ∫(A₂ dq₁ − A₁ dq₂) by quadrature: the 1-form is closed, but N is no product of powers "
    "of the factors that the system brings along"
)
OPEN = (
    "undecided: A₂ dq₁ − A₁ dq₂ is closed at the points tried, but N is no product of powers of "
    "the factors that the system brings along"
)


def page(form: ChaplyginForm) -> str:
    """Coordinates, levels, multiplier, gyroscopic forces and what follows, 100 columns wide."""
    lines = [form.system.title]
    for head, words in _rows(form):
        lines += textwrap.wrap(
            words,
            WIDTH,
            initial_indent=f"  {head}".ljust(MARGIN),
            subsequent_indent=" " * MARGIN,
            break_long_words=False,
            break_on_hyphens=False,
        )
    return "\n".join(lines)


def _rows(form: ChaplyginForm) -> Iterator[tuple[str, str]]:
    names = ", ".join(map(text, form.base.coordinates))
    vector = form.base.normal
    yield "coordinates", names if vector is None else f"{names}, angles of {text(vector)}"
    velocities = ", ".join(map(text, form.base.motion.velocities))
    for constant, integral in form.integrals:
        momenta = f"{text(constant)} = {text(integral.in_momenta)}, M = ∂L/∂({velocities})"
        yield "level", momenta
    yield "energy", f"L = E₂ − E₀ from {form.role}"
    if form.on:
        yield "where", f"{', '.join(f'{text(f)} = 0' for f in form.on)}, a case of its own"
    if form.multiplier is None:
        yield from _refused(form)
        return
    yield "multiplier", f"N = {text(form.multiplier.value)}"
    for factor in poles(form.multiplier):
        yield "", f"not where {text(factor)} = 0, which is a case of its own"
    for factor in form.singular:
        yield "singular", f"where {text(factor)} = 0"
    yield "gyroscopic", f"S̄ = {text(form.gyroscopic)}"
    monopole = form.flux
    if monopole is not None and monopole.value is not None:
        yield "integral", f"∫S̄ = {text(monopole.value)}: {monopole.words}"
    elif monopole is not None:
        yield "integral", f"of S̄: {monopole.words}"
    if form.hamiltonian is not None:
        yield "canonical", "Hamiltonian in the time τ, dτ = N dt, with momenta on the whole base"
    elif monopole is not None and monopole.value == 0:
        yield (
            "canonical",
            "momenta exist on the whole sphere: S̄ = dw, as its integral is 0",
        )
    elif monopole is not None and monopole.value is not None:
        yield "canonical", "no momenta on the whole sphere, as the integral of S̄ is not zero"


def _refused(form: ChaplyginForm) -> Iterator[tuple[str, str]]:
    found = form.obstruction
    if found is None:
        yield "multiplier", BY_QUADRATURE if form.closed_form else OPEN
        return
    at = ", ".join(f"{name} = {value}" for name, value in found.point.items())
    exact = str(found.curl)
    value = exact if len(exact) < LONG else f"{float(sp.Rational(exact)):.6g} (a fraction exactly)"
    yield "multiplier", f"none: d(A₂ dq₁ − A₁ dq₂) is {value} dq₂ ∧ dq₁ at {at}"
    if found.vanishing:
        yield "", f"it vanishes where {' or '.join(f'{text(f)} = 0' for f in found.vanishing)}"
