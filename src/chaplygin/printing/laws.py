"""Laws as a reader meets them on paper: equations, the level they hold on, a caption.

What a law says is written here as pairs of a left side and a formula, for either notation;
:mod:`chaplygin.printing.system` puts them on a page.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import product
from typing import TYPE_CHECKING, Any, TypeAlias

import sympy as sp

from ..core.isomorphism import Isomorphism
from ..core.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Separation,
    Symmetry,
)
from ..core.vectors import Diagonal, Vector, real_symbol, to_components
from .formula import LATEX, UNICODE, Notation, latex, rate, text

if TYPE_CHECKING:
    from ..core.system import System

__all__ = ["caption", "condition_text", "equation", "equation_sides", "formulas", "heading"]

#: A left side, written; and a formula, or what is written already.
Side: TypeAlias = tuple[str, Any]

#: The alternating tensor and the unit tensor by their indices.
_TENSORS = {UNICODE: ("εᵢⱼₖ", "δᵢⱼ"), LATEX: (r"\varepsilon_{ijk}", r"\delta_{ij}")}

#: Entries of a bracket with more operations than this are not expanded to compare them.
_EXPANDED = 400


def heading(law: Law) -> str:
    """What kind of law it is, in words."""
    match law:
        case Integral():
            return "First integral"
        case Measure():
            return "Invariant measure"
        case Symmetry():
            return "Symmetry field"
        case PoissonStructure():
            return "Poisson bracket"
        case ConformallyHamiltonian():
            return "Hamiltonian form" if law.multiplier == 1 else "Conformally Hamiltonian form"
        case Isomorphism():
            return f"The same motion as: {law.target.title}"
        case Separation():
            return "Separation of variables"
        case Reduction():
            return "Reduction"
        case Identity():
            return "Identity"
    return "Law"


def equation(vanishing: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Both sides of ``vanishing = 0`` with the number on the right: γ² = 1; a − b as a = b."""
    if isinstance(vanishing, sp.Add) and len(vanishing.args) == 2:
        minus = [term for term in vanishing.args if term.could_extract_minus_sign()]
        if len(minus) == 1 and not any(term.is_number for term in vanishing.args):
            return vanishing - minus[0], -minus[0]
    number, rest = vanishing.as_coeff_Add()
    if number != 0 and rest.could_extract_minus_sign():
        number, rest = -number, -rest
    return rest, -number


def _solved(vanishing: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Both sides of ``vanishing = 0`` with the derivatives on the left: q̇² = f(q)."""
    terms = sp.Add.make_args(vanishing)
    left = sp.Add(*(term for term in terms if term.has(Rate)))
    if left in (0, vanishing):
        return equation(vanishing)
    right = left - vanishing
    return (-left, -right) if left.could_extract_minus_sign() else (left, right)


def condition_text(law: Law, system: System, write: Callable[[Any], str]) -> str:
    """Where a law holds: "for k = −1" or "on (M, γ) = 0"; empty when it holds everywhere."""
    constants = set(system.defaults)
    for_: list[str] = []
    on: list[str] = []
    for zero in law.on:
        alone = not to_components(zero).free_symbols - constants
        (for_ if alone else on).append(write(sp.Eq(*equation(zero), evaluate=False)))
    parts = [f"for {', '.join(for_)}"] if for_ else []
    parts += [f"on {', '.join(on)}"] if on else []
    return " ".join(parts)


def caption(law: Law, system: System, write: Callable[[Any], str]) -> str:
    """Meaning, level and source of a law, in words."""
    meaning = getattr(law, "meaning", "")
    if meaning.casefold() == heading(law).casefold():
        meaning = ""
    words = ", ".join(filter(None, (meaning, condition_text(law, system, write))))
    source = law.source
    if law.misprint:
        source = f"{source} (misprinted there: {law.misprint})".strip()
    return "; ".join(filter(None, (words, source)))


def formulas(law: Law) -> list[Any]:
    """Every formula that a law shows."""
    match law:
        case Integral():
            found = [law.value]
        case Measure():
            found = [part for pair in law.density for part in pair]
        case Symmetry():
            found = [component for _, component in law.field]
        case PoissonStructure():
            found = [law.matrix, *law.casimirs]
        case ConformallyHamiltonian():
            found = [law.multiplier, law.hamiltonian, *formulas(law.structure)]
        case Isomorphism():
            found = [value for _, value in (*law.map, *law.constants)] + [law.time]
        case Reduction():
            found = [value for _, value in law.quantities] + list(law.equations)
        case Identity():
            found = list(law.value) if isinstance(law.value, tuple | list) else [law.value]
            found += [value for _, value in law.quantities]
        case _:
            found = []
    return [sp.sympify(formula) for formula in (*found, *law.on)]


def equation_sides(law: Law, system: System, notation: Notation) -> list[Side]:
    """The equations that state a law.

    Parameters
    ----------
    law : Law
    system : System
        The system it is claimed of.
    notation : Notation

    Returns
    -------
    list of (str, formula or str)
        Left sides in the notation (empty for a remark among the equations), and right sides.
    """
    write = text if notation is UNICODE else latex
    match law:
        case Integral():
            return [(law.name if notation is UNICODE else rf"\text{{{law.name}}}", law.value)]
        case Measure():
            return [(write(real_symbol("rho")), law.value)]
        case Symmetry():
            return _field(law, system, notation)
        case PoissonStructure():
            return _structure(law, system, notation)
        case ConformallyHamiltonian():
            return _hamiltonian(law, system, notation)
        case Isomorphism():
            return _isomorphism(law, system, notation)
        case Reduction():
            named = [(write(name), value) for name, value in law.quantities]
            stated = map(_solved, law.equations)
            return [*named, *((write(left), right) for left, right in stated)]
        case Identity():
            parts = law.value if isinstance(law.value, tuple | list) else (law.value,)
            named = [(write(name), value) for name, value in law.quantities]
            return [*named, *(_identity(part, bool(named), write) for part in parts)]
    return []


def _identity(vanishing: Any, named: bool, write: Callable[[Any], str]) -> Side:
    """0 = a; or with the derivatives on the left, as of the equations of motion: q̇ = f(q)."""
    scalar_part = not isinstance(sp.sympify(vanishing), sp.MatrixBase | sp.MatrixExpr)
    if scalar_part and (named or sp.sympify(vanishing).has(Rate)):
        left, right = _solved(vanishing)
        if named or right != 0:
            return write(left), right
    return "0", vanishing


def _field(law: Symmetry, system: System, notation: Notation) -> list[Side]:
    """u = (M × e₃, ∂/∂M) + ∂/∂θ, one term a line."""
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


def _hamiltonian(law: ConformallyHamiltonian, system: System, notation: Notation) -> list[Side]:
    """ẋ = N {x, H}, then N, H and the bracket unless it is a law by itself."""
    write = text if notation is UNICODE else latex
    x, N, H = (write(real_symbol(name)) for name in ("x", "N", "H"))
    bracket = _curly(f"{x}, {H}", notation)
    lines: list[Side] = []
    if law.multiplier == 1:
        lines.append((rate(real_symbol("x"), notation), bracket))
    else:
        lines += [(rate(real_symbol("x"), notation), f"{N} {bracket}"), (N, law.multiplier)]
    lines.append((H, law.hamiltonian))
    if law.structure not in system.laws:
        lines += _structure(law.structure, system, notation)
    return lines


def _isomorphism(law: Isomorphism, system: System, notation: Notation) -> list[Side]:
    """The variables of the target, primed where they have the name of something here."""
    write = text if notation is UNICODE else latex
    taken = {str(s) for s in (*system.state, *(name for name, _ in system.definitions))}
    lines: list[Side] = [(_primed(name, str(name) in taken, write), f) for name, f in law.map]
    constants = {str(s) for s in system.defaults}
    lines += [(_primed(s, str(s) in constants, write), value) for s, value in law.constants]
    named = [name for name, _ in law.map if str(name) in taken]
    named += [s for s, _ in law.constants if str(s) in constants]
    for condition in law.onto:
        left, right = equation(_renamed(condition, named))
        lines.append((write(left), right))
    if law.time != 1:
        tau, t = write(real_symbol("tau")), write(real_symbol("t"))
        gone = notation.gradient(tau, t).text.replace("∂", "d").replace(r"\partial", "d")
        lines.append((gone, law.time))
    return lines


def _primed(name: Any, needed: bool, write: Callable[[Any], str]) -> str:
    return write(_primed_symbol(name) if needed else name)


def _primed_symbol(name: Any) -> Any:
    base, bar, index = str(name).partition("_")
    kind = Vector if isinstance(name, Vector) else real_symbol
    return kind(f"{base}prime{bar}{index}")


def _renamed(formula: Any, names: Iterable[Any]) -> Any:
    """A formula with primes at some symbols and vectors, and at the tensors made of them."""
    whole = list(names)
    single = {s for name in whole for s in ((name,) if name.is_Symbol else name.symbols)}
    tensors = [t for t in formula.atoms(Diagonal) if set(t.symbols) <= single]
    changed = {name: _primed_symbol(name) for name in (*whole, *single)}
    changed |= {t: Diagonal(f"{t}prime") for t in tensors}
    return formula.xreplace(changed)


# --- Poisson brackets ----------------------------------------------------------------------


def _curly(inner: str, notation: Notation) -> str:
    return f"{{{inner}}}" if notation is UNICODE else rf"\left\{{{inner}\right\}}"


def _structure(law: PoissonStructure, system: System, notation: Notation) -> list[Side]:
    write = text if notation is UNICODE else latex
    matrix = to_components(law.matrix)
    lines: list[Side] = []
    places = _places(system)
    for index, (one, rows) in enumerate(places):
        for other, columns in places[index:]:
            block = matrix[rows, columns]
            if any(entry != 0 for entry in block):
                lines += _block(one, other, block, system, notation)
    words = []
    if law.casimirs:
        words.append(f"Casimir functions {', '.join(map(write, law.casimirs))}")
    if law.rank is not None:
        words.append(f"rank {law.rank}")
    if words and notation is UNICODE:
        lines.append(("", "; ".join(words)))
    elif words:
        listed = r",\; ".join(map(write, law.casimirs))
        lines.append(("", rf"\text{{Casimir functions: }} {listed}" if law.casimirs else ""))
        if law.rank is not None:
            lines[-1] = ("", rf"{lines[-1][1]}{',' if listed else ''}\; \text{{rank }} {law.rank}")
    return lines


def _places(system: System) -> list[tuple[Any, slice]]:
    places, first = [], 0
    for name in system.state:
        size = 1 if isinstance(name, sp.Symbol) else len(name.symbols)
        places.append((name, slice(first, first + size)))
        first += size
    return places


def _block(
    one: Any, other: Any, block: sp.MatrixBase, system: System, notation: Notation
) -> list[Side]:
    """The brackets of two variables, with indices where all components follow one pattern."""
    write = text if notation is UNICODE else latex
    epsilon, delta = _TENSORS[notation]
    indexed = _curly(f"{_component(one, 'i', write)}, {_component(other, 'j', write)}", notation)
    if block.shape == (3, 3) and _skew(block):
        common, twist = _common_factor((block[1, 2], block[2, 0], block[0, 1]))
        head = epsilon if common == 1 else f"{_guarded(common, notation)} {epsilon}"
        sums = _combination(twist, system)
        if sums is None:
            vector = sp.ImmutableDenseMatrix(twist)
            return [(indexed, f"{head} {write(real_symbol('w_k'))}"), (write(Vector("w")), vector)]
        shown, minus = _guarded(sums("k"), notation), notation.minus
        sign = minus if shown.startswith(minus) else ""
        return [(indexed, f"{sign}{head} {shown.removeprefix(minus)}")]
    if block.shape == (3, 3) and block.is_diagonal() and len(set(block.diagonal())) == 1:
        factor = block[0, 0]
        return [(indexed, delta if factor == 1 else f"{delta} {_guarded(factor, notation)}")]
    if block.shape in ((1, 3), (3, 1)):
        sums = _combination(tuple(block), system)
        if sums is not None:
            index = "j" if block.shape == (1, 3) else "i"
            return [(indexed, sums(index))]
    if block.shape == (3, 3) and one != other:
        common, entries = _common_factor(tuple(block))
        body = "B_{ij}" if notation is LATEX else "Bᵢⱼ"
        head = body if common == 1 else f"{_guarded(common, notation)} {body}"
        return [(indexed, head), (write(Vector("B")), sp.ImmutableDenseMatrix(3, 3, entries))]
    return _entries(one, other, block, notation)


def _guarded(factor: Any, notation: Notation) -> str:
    """A factor, in brackets if it is a sum."""
    written = (text if notation is UNICODE else latex)(factor)
    return notation.brackets(written) if isinstance(factor, sp.Add) else written


def _common_factor(entries: tuple[sp.Expr, ...]) -> tuple[sp.Expr, tuple[sp.Expr, ...]]:
    """What all that is not zero is a multiple of, and what is left."""
    present = [entry for entry in entries if entry != 0]
    shared = [
        factor
        for factor in sp.Mul.make_args(present[0])
        if factor != -1 and all(factor in sp.Mul.make_args(other) for other in present[1:])
    ]
    common = sp.Mul(*shared)
    return common, tuple(entry / common for entry in entries)


def _component(name: Any, index: str, write: Callable[[Any], str]) -> str:
    return write(name) if isinstance(name, sp.Symbol) else write(real_symbol(f"{name}_{index}"))


def _entries(one: Any, other: Any, block: sp.MatrixBase, notation: Notation) -> list[Side]:
    write = text if notation is UNICODE else latex
    names = [[name] if isinstance(name, sp.Symbol) else name.symbols for name in (one, other)]
    lines: list[Side] = []
    for (i, left), (j, right) in product(*map(enumerate, names)):
        if block[i, j] != 0 and (one != other or i < j):
            lines.append((_curly(f"{write(left)}, {write(right)}", notation), block[i, j]))
    return lines


def _vanishes(formula: sp.Expr) -> bool:
    if formula == 0:
        return True
    return bool(sp.count_ops(formula) < _EXPANDED and sp.expand(formula) == 0)


def _skew(block: sp.MatrixBase) -> bool:
    return all(_vanishes(block[i, j] + block[j, i]) for i in range(3) for j in range(i, 3))


def _combination(triple: tuple[sp.Expr, ...], system: System) -> Callable[[str], sp.Expr] | None:
    """A sum of the state's vectors that has these three components, as a function of the index."""
    vectors = [v for v in system.state if isinstance(v, Vector) and len(v.symbols) == 3]
    choices = [list(_taken_out(term, vectors)) for term in _terms(triple[0])]
    for choice in product(*choices):
        values = [sp.Add(*(c * v.symbols[k] for c, v in choice)) for k in range(3)]
        if all(_vanishes(x - y) for x, y in zip(triple, values, strict=True)):

            def component(index: str, chosen: Any = choice) -> sp.Expr:
                return sp.Add(*(c * real_symbol(f"{v}_{index}") for c, v in chosen))

            return component
    return None


def _terms(formula: sp.Expr) -> list[sp.Expr]:
    """The terms of a sum, also of one that is a factor of a product."""
    sums = [factor for factor in sp.Mul.make_args(formula) if isinstance(factor, sp.Add)]
    if len(sums) != 1:
        return list(sp.Add.make_args(formula))
    rest = formula / sums[0]
    return [rest * term for term in sums[0].args]


def _taken_out(term: sp.Expr, vectors: list[Vector]) -> Iterator[tuple[sp.Expr, Vector]]:
    """Each way to write a term as a multiple of the first component of a vector."""
    for vector in vectors:
        if vector.symbols[0] in sp.Mul.make_args(term):
            yield term / vector.symbols[0], vector
