"""The surfaces drawn by a page, as formulas of its parameters."""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.formulas.array_evaluation import read_formulas
from flowlanes.formulas.graph import Term
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, dot, real_symbol
from nonholonomic.mechanics.ball.ball import RollingBall
from nonholonomic.mechanics.rolling.contact import contact

from ..experiment.study import Study

_GAMMA = Vector("gamma")


def surface_terms(study: Study, reduced: System) -> tuple[dict[str, list[Term]], int]:
    """Terms for the points of each surface as functions of three numbers of a reduced state.

    Parameters
    ----------
    study : Study
    reduced : System

    Returns
    -------
    pieces : mapping
        ``contact``: the point of the body with the outward normal −γ (body axes); ``inertia``: the
        same of the ellipsoid (x, Ix) = 1; ``ground``, at a place in space: f, ∇f, and the distance
        of f = 0 from the surface that carries a ball, on the ball's side. Only surfaces given by
        formulas are included.
    place : int
        Index of the first component of γ, or of the position, in the reduced state.
    """
    names = reduced.symbols
    place = names.index(_GAMMA.symbols[0]) if _GAMMA in reduced.state else 0
    three = names[place : place + 3]
    formulas = _formulas(study, reduced)
    if len(three) < 3 or not formulas:
        return {}, 0
    reader, _ = read_formulas(reduced)
    pieces = {}
    for name, (given, parts) in formulas.items():
        put = dict(zip(given, three, strict=True))
        pieces[name] = [reader(sp.sympify(part).xreplace(put)) for part in parts]
    return pieces, place


def _formulas(
    study: Study, reduced: System
) -> dict[str, tuple[tuple[sp.Symbol, ...], list[sp.Expr]]]:
    """Formulas by name, each with the symbols of its three arguments."""
    found: dict[str, list[sp.Expr]] = {}
    subject, rolling = study.subject, study.rolling
    inertia = _inertia(study, reduced)
    if inertia is not None:
        # (x, Ix) = 1 has the support function √(γ, I⁻¹γ), whose gradient is the contact point
        inverse = inertia**-1 * _GAMMA
        found["inertia"] = scalars(-inverse / sp.sqrt(dot(_GAMMA, inverse)))
    if subject.ball is not None:
        b = real_symbol("b")
        found["contact"] = [-b * s for s in _GAMMA.symbols]
    elif rolling is not None and _GAMMA in reduced.state:
        found["contact"] = scalars(contact(rolling.equivalent.body.shape, rolling.surface).r)
    elif inertia is not None and rolling is None:
        # The ellipsoid represents a body whose shape is irrelevant, initially scaled to length 1.
        least = min(study.system.defaults[s] for s in Diagonal("I").symbols)
        found["contact"] = [sp.sqrt(least) * part for part in found["inertia"]]
    formulas = {name: (_GAMMA.symbols, parts) for name, parts in found.items()}
    if subject.ball is not None:
        formulas["ground"] = _ground(subject.ball)
    elif subject.surface is not None and not subject.surface.is_even:
        symbols = Vector("x").symbols
        f = subject.surface.equation(symbols)
        formulas["ground"] = symbols, [f, *(f.diff(s) for s in symbols), sp.S.Zero]
    return formulas


def _inertia(study: Study, reduced: System) -> MatrixExpr | None:
    """The inertia tensor in terms of parameters."""
    known = {p.symbol for p in reduced.parameters}
    options: tuple[Diagonal | Symmetric, ...] = (Diagonal("I"), Symmetric("I"))
    return next((tensor for tensor in options if known >= set(tensor.symbols)), None)


def _ground(ball: RollingBall) -> tuple[tuple[sp.Symbol, ...], list[sp.Expr]]:
    """f, ∇f and the distance between f = 0 and the carrying surface."""
    symbols = Vector("x").symbols
    f, shift = ball.carrying, sp.S.Zero
    if ball.carrier == "centre":
        b = real_symbol("b")
        below = ball.surface.equation(symbols, -b)
        f, shift = (f, b) if below is None else (below, sp.S.Zero)
    return symbols, [f, *(f.diff(s) for s in symbols), shift]
