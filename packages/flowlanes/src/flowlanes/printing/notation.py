"""Notations for the parts of a formula: Unicode and LaTeX."""

from __future__ import annotations

import re
import unicodedata
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from itertools import pairwise
from typing import ClassVar

import sympy as sp

from .symbol_names import GREEK, SymbolName


class Precedence(IntEnum):
    """Precedence of a part of a formula, weakest binding first."""

    SUM = 0
    RATIO = 1
    CROSS = 2
    PRODUCT = 3
    POWER = 4
    ATOM = 5


@dataclass(frozen=True)
class Fragment:
    """A formatted formula with its precedence."""

    text: str
    level: Precedence = Precedence.ATOM


class Notation(ABC):
    """A notation; the instances are :data:`UNICODE` and :data:`LATEX`."""

    minus: str
    cross: str
    dyad: str
    relations: ClassVar[Mapping[str, str]]
    connectives: ClassVar[Mapping[type, str]]
    constants: ClassVar[Mapping[sp.Basic, str]]

    def guard(self, piece: Fragment, level: Precedence) -> str:
        """The text of `piece`, in brackets if it binds more weakly than `level`."""
        return piece.text if piece.level >= level else self.brackets(piece.text)

    @abstractmethod
    def brackets(self, inner: str) -> str:
        """(inner); the scalar product if inner is "u, v"."""

    @abstractmethod
    def norm(self, inner: str) -> Fragment:
        """|inner|, the length of a vector or the absolute value of a scalar."""

    @abstractmethod
    def letter(self, letter: SymbolName, bold: bool) -> Fragment:
        """A name."""

    @abstractmethod
    def number(self, value: sp.Float) -> Fragment:
        """A positive decimal number."""

    @abstractmethod
    def product(
        self,
        coefficient: tuple[int, int],
        above: Sequence[Fragment],
        below: Sequence[Fragment],
        vector: Fragment | None,
    ) -> Fragment:
        """(p/q) · above / below · vector."""

    @abstractmethod
    def power(self, base: Fragment, exponent: str) -> Fragment:
        """base^exponent, where the exponent is formatted in this notation."""

    @abstractmethod
    def root(self, inner: Fragment) -> Fragment:
        """The square root."""

    @abstractmethod
    def call(self, function: str, arguments: Sequence[str], exponent: int = 1) -> Fragment:
        """A function of its arguments, raised to a power."""

    @abstractmethod
    def transpose(self, base: Fragment) -> Fragment:
        """The transposed tensor."""

    @abstractmethod
    def gradient(self, value: str, variable: str) -> Fragment:
        """∂value/∂variable."""

    @abstractmethod
    def quotient(self, above: str, below: str) -> Fragment:
        """A derivative as a quotient of two formatted parts."""

    @abstractmethod
    def partial(self, name: str, order: int, above: bool = False) -> str:
        """∂²U in the numerator of a derivative, ∂x² in the denominator."""

    @abstractmethod
    def matrix(self, rows: Sequence[Sequence[str]]) -> Fragment:
        """A matrix by its entries, row by row."""

    @abstractmethod
    def fallback(self, formula: sp.Basic) -> str:
        """A formula without a rule, as printed by SymPy."""


_SUPERSCRIPTS = str.maketrans("0123456789-−", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁻")
_SUBSCRIPTS = {
    **dict(zip("0123456789", "₀₁₂₃₄₅₆₇₈₉", strict=True)),
    **dict(zip("aehijklmnoprstuv", "ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥ", strict=True)),
    ",": ",",
}
_ACCENTS = {
    "dot": "\N{COMBINING DOT ABOVE}",
    "ddot": "\N{COMBINING DIAERESIS}",
    "tilde": "\N{COMBINING TILDE}",
    "hat": "\N{COMBINING CIRCUMFLEX ACCENT}",
    "bar": "\N{COMBINING MACRON}",
}
#: LaTeX commands of Greek letters in the shape of the Unicode characters: φ, not ϕ.
_GREEK = {"omicron": "o", "phi": r"\varphi", "epsilon": r"\varepsilon"}
_FRACTIONS = {(1, 2): "½", (1, 3): "⅓", (2, 3): "⅔", (1, 4): "¼", (3, 4): "¾", (1, 8): "⅛"}


class _Unicode(Notation):
    minus = "−"
    cross = " × "
    dyad = " ⊗ "
    relations: ClassVar[Mapping[str, str]] = {
        "==": "=",
        "!=": "≠",
        "<": "<",
        "<=": "≤",
        ">": ">",
        ">=": "≥",
    }
    connectives: ClassVar[Mapping[type, str]] = {sp.And: " and ", sp.Or: " or "}
    constants: ClassVar[Mapping[sp.Basic, str]] = {sp.pi: "π", sp.E: "e"}

    def brackets(self, inner: str) -> str:
        return f"({inner})"

    def norm(self, inner: str) -> Fragment:
        return Fragment(f"|{inner}|")

    def letter(self, letter: SymbolName, bold: bool) -> Fragment:
        base = GREEK.get(letter.base, letter.base)
        marks = "".join(_ACCENTS[accent] for accent in letter.accents)
        if len(base) == 1 or not marks:
            head = unicodedata.normalize("NFC", base + marks)
        else:
            # A combining accent on a word would be placed on its last letter.
            order = sum(2 if accent == "ddot" else 1 for accent in letter.accents)
            power = {1: "", 2: "²", 3: "³"}.get(order, f"^{order}")
            head = f"d{power}({base})/dt{power}"
        sub = ",".join(GREEK.get(part, part) for part in letter.subscript.split(","))
        if all(character in _SUBSCRIPTS for character in sub):
            sub = "".join(_SUBSCRIPTS[character] for character in sub)
        else:
            sub = f"_{sub}"
        return Fragment(head + "′″‴"[letter.primes - 1 : letter.primes] + sub)

    def number(self, value: sp.Float) -> Fragment:
        return Fragment(f"{float(value):.15g}")

    def product(
        self,
        coefficient: tuple[int, int],
        above: Sequence[Fragment],
        below: Sequence[Fragment],
        vector: Fragment | None,
    ) -> Fragment:
        p, q = coefficient
        factors = [self.guard(piece, Precedence.PRODUCT) for piece in above]
        if not below and coefficient in _FRACTIONS:
            factors.insert(0, _FRACTIONS[coefficient])
            p, q = 1, 1
        if p != 1 or not (factors or vector):
            factors.insert(0, str(p))
        divisors = [self.guard(piece, Precedence.POWER) for piece in below]
        if q != 1:
            divisors.insert(0, str(q))
        level = Precedence.PRODUCT
        if vector:
            factors.append(self.guard(vector, Precedence.CROSS))
            level = min(level, max(vector.level, Precedence.CROSS))
        head = " ".join(factors)
        if not divisors:
            return Fragment(head, level)
        tail = divisors[0] if len(divisors) == 1 else self.brackets(" ".join(divisors))
        return Fragment(f"{head} / {tail}", Precedence.RATIO)

    def power(self, base: Fragment, exponent: str) -> Fragment:
        head = self.guard(base, Precedence.ATOM)
        if re.fullmatch(r"−?\d+", exponent):
            return Fragment(head + exponent.translate(_SUPERSCRIPTS), Precedence.POWER)
        simple = re.fullmatch(r"\w", exponent)
        return Fragment(
            f"{head}^{exponent if simple else self.brackets(exponent)}", Precedence.POWER
        )

    def root(self, inner: Fragment) -> Fragment:
        return Fragment(f"√{self.guard(inner, Precedence.ATOM)}", Precedence.POWER)

    def call(self, function: str, arguments: Sequence[str], exponent: int = 1) -> Fragment:
        raised = "" if exponent == 1 else str(exponent).translate(_SUPERSCRIPTS)
        return Fragment(f"{function}{raised}({', '.join(arguments)})", Precedence.POWER)

    def transpose(self, base: Fragment) -> Fragment:
        return Fragment(self.guard(base, Precedence.ATOM) + "ᵀ", Precedence.POWER)

    def gradient(self, value: str, variable: str) -> Fragment:
        return Fragment(f"∂{value}/∂{variable}", Precedence.PRODUCT)

    def quotient(self, above: str, below: str) -> Fragment:
        return Fragment(
            f"{above}/{self.brackets(below) if ' ' in below else below}", Precedence.PRODUCT
        )

    def partial(self, name: str, order: int, above: bool = False) -> str:
        raised = "" if order == 1 else str(order).translate(_SUPERSCRIPTS)
        return f"∂{raised}{name}" if above else f"∂{name}{raised}"

    def matrix(self, rows: Sequence[Sequence[str]]) -> Fragment:
        if all(len(row) == 1 for row in rows):
            return Fragment(f"({', '.join(row[0] for row in rows)})")
        return Fragment(f"[{'; '.join(', '.join(row) for row in rows)}]")

    def fallback(self, formula: sp.Basic) -> str:
        return str(sp.sstr(formula))


class _Latex(Notation):
    minus = "-"
    cross = r" \times "
    dyad = r" \otimes "
    relations: ClassVar[Mapping[str, str]] = {
        "==": "=",
        "!=": r"\neq",
        "<": "<",
        "<=": r"\leq",
        ">": ">",
        ">=": r"\geq",
    }
    connectives: ClassVar[Mapping[type, str]] = {
        sp.And: r" \text{ and } ",
        sp.Or: r" \text{ or } ",
    }
    constants: ClassVar[Mapping[sp.Basic, str]] = {sp.pi: r"\pi", sp.E: "e"}

    #: Maximum length of the components of a vector that is not written as a column.
    _longest_list = 200

    _functions = frozenset({"sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "log", "exp"}) | {
        "arcsin",
        "arccos",
        "arctan",
    }

    def brackets(self, inner: str) -> str:
        return rf"\left({inner}\right)"

    def norm(self, inner: str) -> Fragment:
        return Fragment(rf"\left|{inner}\right|")

    def letter(self, letter: SymbolName, bold: bool) -> Fragment:
        head = self._symbol(letter.base)
        if bold and letter.base in GREEK:
            head = rf"\boldsymbol{{{head}}}"
        elif bold and len(letter.base) == 1:
            head = rf"\mathbf{{{head}}}"
        if len(letter.base) > 1 and letter.base not in GREEK:
            for _ in letter.accents:
                head = rf"\frac{{d\,{head}}}{{dt}}"
        else:
            for accent in letter.accents:
                head = rf"\{accent}{{{head}}}"
        if letter.subscript:
            parts = (self._symbol(part) for part in letter.subscript.split(","))
            head += f"_{{{','.join(parts)}}}"
        if letter.primes:
            head += "^{" + r"\prime" * letter.primes + "}"
        return Fragment(head, Precedence.POWER if letter.primes else Precedence.ATOM)

    @staticmethod
    def _symbol(name: str) -> str:
        if name in GREEK:
            return _GREEK.get(name, rf"\{name}")
        if len(name) == 1 or name.isdigit():
            return name
        return rf"\text{{{name.replace('_', ' ')}}}"

    def number(self, value: sp.Float) -> Fragment:
        mantissa, _, exponent = f"{float(value):.15g}".partition("e")
        if not exponent:
            return Fragment(mantissa)
        return Fragment(rf"{mantissa} \cdot 10^{{{int(exponent)}}}", Precedence.PRODUCT)

    def product(
        self,
        coefficient: tuple[int, int],
        above: Sequence[Fragment],
        below: Sequence[Fragment],
        vector: Fragment | None,
    ) -> Fragment:
        p, q = coefficient
        divisors = [str(q)] if q != 1 else []
        alone = len(below) == 1 and not divisors
        divisors += [self.guard(x, Precedence.SUM if alone else Precedence.PRODUCT) for x in below]
        first = [str(p)] if p != 1 else []
        # A bare rational coefficient is placed before the factors, not above them.
        lifted = bool(divisors) and (bool(below) or not (above or vector))
        alone = lifted and len(above) == 1 and not first
        factors = [self.guard(x, Precedence.SUM if alone else Precedence.PRODUCT) for x in above]
        level = Precedence.PRODUCT
        if lifted:
            head = [
                rf"\frac{{{_side_by_side(first + factors) or '1'}}}{{{_side_by_side(divisors)}}}"
            ]
        elif divisors:
            head = [rf"\frac{{{p}}}{{{divisors[0]}}}", *factors]
        else:
            head = first + factors
        if vector:
            head.append(self.guard(vector, Precedence.CROSS))
            level = min(level, max(vector.level, Precedence.CROSS))
        return Fragment(_side_by_side(head) or "1", level)

    def power(self, base: Fragment, exponent: str) -> Fragment:
        return Fragment(f"{self.guard(base, Precedence.ATOM)}^{{{exponent}}}", Precedence.POWER)

    def root(self, inner: Fragment) -> Fragment:
        return Fragment(rf"\sqrt{{{inner.text}}}", Precedence.POWER)

    def call(self, function: str, arguments: Sequence[str], exponent: int = 1) -> Fragment:
        known = function in self._functions
        name = rf"\{function}" if known else rf"\operatorname{{{function}}}"
        raised = "" if exponent == 1 else f"^{{{exponent}}}"
        return Fragment(f"{name}{raised}{self.brackets(', '.join(arguments))}", Precedence.POWER)

    def transpose(self, base: Fragment) -> Fragment:
        return self.power(base, r"\top")

    def gradient(self, value: str, variable: str) -> Fragment:
        return Fragment(rf"\frac{{\partial {value}}}{{\partial {variable}}}", Precedence.PRODUCT)

    def quotient(self, above: str, below: str) -> Fragment:
        return Fragment(rf"\frac{{{above}}}{{{below}}}", Precedence.PRODUCT)

    def partial(self, name: str, order: int, above: bool = False) -> str:
        raised = "" if order == 1 else f"^{{{order}}}"
        return rf"\partial{raised} {name}" if above else rf"\partial {name}{raised}"

    def matrix(self, rows: Sequence[Sequence[str]]) -> Fragment:
        listed = r",\, ".join(row[0] for row in rows)
        if len(rows[0]) == 1 and len(listed) <= self._longest_list:
            return Fragment(self.brackets(listed))
        body = r" \\ ".join(" & ".join(row) for row in rows)
        return Fragment(rf"\begin{{pmatrix}} {body} \end{{pmatrix}}")

    def fallback(self, formula: sp.Basic) -> str:
        return str(sp.latex(formula))


UNICODE: Notation = _Unicode()
LATEX: Notation = _Latex()


def _side_by_side(factors: Sequence[str]) -> str:
    """Factors of a product in LaTeX, with a space next to words."""
    text = factors[0] if factors else ""
    for left, right in pairwise(factors):
        wide = any(factor.startswith(r"\text{") for factor in (left, right))
        text += rf" \, {right}" if wide else f" {right}"
    return text
