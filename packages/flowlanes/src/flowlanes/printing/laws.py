"""Laws in print notation: equations, level and caption.

A law is given as pairs of a left side and a formula, for either notation;
:mod:`flowlanes.printing.system` assembles the page.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import singledispatch

import sympy as sp

from ..system.isomorphism import Isomorphism
from ..system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Symmetry,
)
from ..system.system import Name, System
from ..system.vectors import Diagonal, Vector, real_symbol
from .formula import latex, rate, text
from .notation import UNICODE, Notation
from .poisson_brackets import Side, bracket_sides, curly_brackets


def equation(vanishing: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Both sides of ``vanishing = 0``, a number on the right: u² = 1, or a = b."""
    if isinstance(vanishing, sp.Add) and len(vanishing.args) == 2:
        minus = [term for term in vanishing.args if term.could_extract_minus_sign()]
        if len(minus) == 1 and not any(term.is_number for term in vanishing.args):
            return vanishing - minus[0], -minus[0]
    number, remainder = vanishing.as_coeff_Add()
    if number != 0 and remainder.could_extract_minus_sign():
        number, remainder = -number, -remainder
    return remainder, -number


def _with_derivatives_left(vanishing: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Both sides of ``vanishing = 0`` with the derivatives on the left: q̇² = f(q)."""
    terms = sp.Add.make_args(vanishing)
    left = sp.Add(*(term for term in terms if term.has(Rate)))
    if left in (0, vanishing):
        return equation(vanishing)
    right = left - vanishing
    return (-left, -right) if left.could_extract_minus_sign() else (left, right)


def condition_text(law: Law, system: System, write: Callable[[sp.Basic], str]) -> str:
    """The level of a law: "for k = −1" or "on (M, u) = 0"; empty without one."""
    constants = set(system.defaults)
    for_: list[str] = []
    on: list[str] = []
    for zero, scalar in zip(law.level, law.scalar.level, strict=True):
        alone = not scalar.free_symbols - constants
        (for_ if alone else on).append(write(sp.Eq(*equation(zero), evaluate=False)))
    parts = [f"for {', '.join(for_)}"] if for_ else []
    parts += [f"on {', '.join(on)}"] if on else []
    return " ".join(parts)


def caption(law: Law, system: System, write: Callable[[sp.Basic], str]) -> str:
    """Meaning, level and source of a law, in words."""
    meaning = getattr(law, "meaning", "")
    if meaning.casefold() == law.heading.casefold():
        meaning = ""
    words = ", ".join(filter(None, (meaning, condition_text(law, system, write))))
    source = law.source
    if law.misprint:
        source = f"{source} (misprinted there: {law.misprint})".strip()
    return "; ".join(filter(None, (words, source)))


def equation_sides(law: Law, system: System, notation: Notation) -> list[Side]:
    """The equations that state a law.

    Parameters
    ----------
    law : Law
    system : System
        The system for which it is claimed.
    notation : Notation

    Returns
    -------
    list of (str, formula or str)
        Left sides in the notation (empty for a remark among the equations), and right sides;
        trivial equations such as H = H are omitted.
    """
    write = text if notation is UNICODE else latex
    sides = _all_sides(law, system, notation)
    return [
        (left, right) for left, right in sides if isinstance(right, str) or left != write(right)
    ]


@singledispatch
def _all_sides(law: Law, system: System, notation: Notation) -> list[Side]:
    """The sides given by the law; some kinds of law have a special form below."""
    write = text if notation is UNICODE else latex
    return [
        (_name(side, notation) if isinstance(side, str) else write(side), value)
        for side, value in law.sides()
    ]


def _name(word: str, notation: Notation) -> str:
    """A name as a left side."""
    return word if notation is UNICODE else rf"\text{{{word}}}"


@_all_sides.register
def _(law: Integral, system: System, notation: Notation) -> list[Side]:
    return [(_name(law.name, notation), law.value)]


@_all_sides.register
def _(law: Measure, system: System, notation: Notation) -> list[Side]:
    write = text if notation is UNICODE else latex
    return [(write(real_symbol("rho")), law.value)]


@_all_sides.register
def _(law: PoissonStructure, system: System, notation: Notation) -> list[Side]:
    return bracket_sides(law, system, notation)


@_all_sides.register
def _(law: Reduction, system: System, notation: Notation) -> list[Side]:
    write = text if notation is UNICODE else latex
    named = [(write(name), value) for name, value in law.quantities]
    stated = map(_with_derivatives_left, law.equations)
    return [*named, *((write(left), right) for left, right in stated)]


@_all_sides.register
def _(law: Identity, system: System, notation: Notation) -> list[Side]:
    write = text if notation is UNICODE else latex
    parts = law.value if isinstance(law.value, tuple | list) else (law.value,)
    named = [(write(name), value) for name, value in law.quantities]
    return [*named, *(_identity(part, bool(named), write) for part in parts)]


def _identity(vanishing: sp.Basic, has_names: bool, write: Callable[[sp.Basic], str]) -> Side:
    """0 = a; with derivatives on the left as in equations of motion: q̇ = f(q)."""
    scalar_part = not isinstance(sp.sympify(vanishing), sp.MatrixBase | sp.MatrixExpr)
    if scalar_part and (has_names or sp.sympify(vanishing).has(Rate)):
        left, right = _with_derivatives_left(vanishing)
        if has_names or right != 0:
            return write(left), right
    return "0", vanishing


@_all_sides.register
def _field(law: Symmetry, system: System, notation: Notation) -> list[Side]:
    """u = (M × e₃, ∂/∂M) + ∂/∂θ, one term per line."""
    write = text if notation is UNICODE else latex
    declared = {str(name): name for name in system.state}
    lines: list[Side] = []
    for name, component in law.field:
        along = notation.gradient("", write(declared.get(str(name), name))).text
        if isinstance(name, Vector):
            term = notation.brackets(f"{write(component)}, {along}")
        elif component == 1:
            term = along
        else:
            loose = isinstance(component, sp.Add)
            term = f"{notation.brackets(write(component)) if loose else write(component)} {along}"
        if lines:
            minus = term.startswith(notation.minus)
            term = f"{notation.minus} {term[1:]}" if minus else f"+ {term}"
        lines.append(("" if lines else write(real_symbol("u")), term))
    return lines


@_all_sides.register
def _hamiltonian(law: ConformallyHamiltonian, system: System, notation: Notation) -> list[Side]:
    """ẋ = N {x, H}, then N, H, and the bracket unless it is a separate law."""
    write = text if notation is UNICODE else latex
    x, N, H = (write(real_symbol(name)) for name in ("x", "N", "H"))
    bracket = curly_brackets(f"{x}, {H}", notation)
    lines: list[Side] = []
    if law.multiplier == 1:
        lines.append((rate(real_symbol("x"), notation), bracket))
    else:
        lines += [(rate(real_symbol("x"), notation), f"{N} {bracket}"), (N, law.multiplier)]
    lines.append((H, law.hamiltonian))
    if law.structure not in system.laws:
        lines += bracket_sides(law.structure, system, notation)
    return lines


@_all_sides.register
def _isomorphism(law: Isomorphism, system: System, notation: Notation) -> list[Side]:
    """The variables of the target, primed if their names occur in the source system."""
    write = text if notation is UNICODE else latex
    names = {str(s) for s in (*system.state, *(name for name, _ in system.definitions))}
    lines: list[Side] = [(_primed_text(name, str(name) in names, write), f) for name, f in law.map]
    constants = {str(s) for s in system.defaults}
    lines += [(_primed_text(s, str(s) in constants, write), value) for s, value in law.constants]
    named = [name for name, _ in law.map if str(name) in names]
    named += [s for s, _ in law.constants if str(s) in constants]
    for condition in law.onto:
        left, right = equation(_with_primes(condition, named))
        lines.append((write(left), right))
    if law.time != 1:
        tau, t = write(real_symbol("tau")), write(real_symbol("t"))
        gone = notation.gradient(tau, t).text.replace("∂", "d").replace(r"\partial", "d")
        lines.append((gone, law.time))
    return lines


def _primed_text(name: Name, with_prime: bool, write: Callable[[sp.Basic], str]) -> str:
    return write(_primed_symbol(name) if with_prime else name)


def _primed_symbol(name: Name) -> Name:
    base, bar, index = str(name).partition("_")
    kind = Vector if isinstance(name, Vector) else real_symbol
    return kind(f"{base}prime{bar}{index}")


def _with_primes(formula: sp.Basic, names: Iterable[Name]) -> sp.Basic:
    """A formula with primes on some symbols and vectors, and on their tensors."""
    whole = list(names)
    single = {s for name in whole for s in ((name,) if name.is_Symbol else name.symbols)}
    tensors = [t for t in formula.atoms(Diagonal) if set(t.symbols) <= single]
    changed = {name: _primed_symbol(name) for name in (*whole, *single)}
    changed |= {t: Diagonal(f"{t}prime") for t in tensors}
    return formula.xreplace(changed)
