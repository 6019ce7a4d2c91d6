"""Formulas as on paper, in Unicode for a terminal and in LaTeX, by one set of rules.

A :class:`_Writer` walks through a formula and decides what a human would: which term and which
factor comes first, what goes below the fraction line, what needs no brackets.  A
:class:`_Notation` knows how the pieces look.
"""

from __future__ import annotations

import re
import unicodedata
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Any, ClassVar

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.matrices.expressions import (
    Identity,
    Inverse,
    MatAdd,
    MatMul,
    MatPow,
    MatrixExpr,
    Transpose,
    ZeroMatrix,
)

from .statements import Rate
from .vectors import Cross, Diagonal, Dot, Gradient, Symmetric, Vector

__all__ = ["LATEX", "UNICODE", "Notation", "latex", "rate", "signed_terms", "text", "width"]


def text(formula: Any) -> str:
    """A formula in one line of Unicode, such as ``A M + m (A r, M) A r / (1 − m (r, A r))``.

    Parameters
    ----------
    formula : sympy.Expr, MatrixExpr or number
        A scalar or vector formula, a tensor, or a relation between scalars.

    Returns
    -------
    str
        ``×`` is the vector product, ``(u, v)`` the scalar product, ``u²`` the square (u, u),
        ``u ⊗ v`` the dyad, ``E`` the unit tensor and ``∂U/∂γ`` a gradient.
    """
    return _Writer(UNICODE).piece(sp.sympify(formula)).text


def latex(formula: Any) -> str:
    r"""A formula in LaTeX (math mode), by the same rules as :func:`text`.

    Vectors and tensors are bold: ``\mathbf{M} \times \boldsymbol{\omega}``.
    """
    return _Writer(LATEX).piece(sp.sympify(formula)).text


def rate(name: Any, notation: Notation) -> str:
    """The time derivative of a named vector or scalar: ``γ̇``."""
    letter = _letter(str(name)).dotted()
    return notation.letter(letter, bold=not isinstance(name, sp.Symbol)).text


def signed_terms(formula: Any, notation: Notation) -> list[tuple[str, str]]:
    """The terms of a sum in order, each with its sign (``""`` or minus for the first, then ± )."""
    writer = _Writer(notation)
    found = []
    for index, (negative, piece) in enumerate(writer.terms(sp.sympify(formula))):
        plus = "+" if index else ""
        found.append((notation.minus if negative else plus, notation.guard(piece, Level.RATIO)))
    return found


def width(line: str) -> int:
    """Columns that `line` takes on a terminal: combining accents take none."""
    return sum(not unicodedata.combining(character) for character in line)


# --- names ---------------------------------------------------------------------------------

_GREEK = {
    **{
        unicodedata.name(chr(code)).rsplit(" ", 1)[-1].lower(): chr(code)
        for code in range(ord("α"), ord("ω") + 1)
        if code != ord("ς")
    },
    "lambda": "λ",
    "Gamma": "Γ",
    "Delta": "Δ",
    "Theta": "Θ",
    "Lambda": "Λ",
    "Xi": "Ξ",
    "Pi": "Π",
    "Sigma": "Σ",
    "Upsilon": "Υ",
    "Phi": "Φ",
    "Psi": "Ψ",
    "Omega": "Ω",
    "ell": "ℓ",
}
_GREEK.pop("lamda", None)

_NAME = re.compile(
    r"(?P<base>[^\W\d_]+?)(?P<accent>ddot|dot|tilde|hat|bar|prime(?P<primes>\d?))?"
    r"(?P<number>\d*)(?:_(?P<sub>\w+))?"
)


@dataclass(frozen=True)
class _Letter:
    """A name as spelt in code, taken apart: ``rdot_1`` is r with a dot and subscript 1."""

    base: str
    accents: tuple[str, ...] = ()
    primes: int = 0
    subscript: str = ""

    def dotted(self) -> _Letter:
        """The same name for the rate of what it names."""
        accents = (*self.accents, "dot")
        if accents[-2:] == ("dot", "dot"):
            accents = (*accents[:-2], "ddot")
        return _Letter(self.base, accents, self.primes, self.subscript)


def _letter(name: str) -> _Letter:
    match = _NAME.fullmatch(name)
    if match is None:
        return _Letter(name)
    base, accent, primes, number, sub = match.group("base", "accent", "primes", "number", "sub")
    parts = [part for part in (number, *(sub or "").split("_")) if part]
    subscript = ",".join(parts)
    if accent is None:
        return _Letter(base, subscript=subscript)
    if accent.startswith("prime"):
        return _Letter(base, primes=int(primes or 1), subscript=subscript)
    return _Letter(base, (accent,), subscript=subscript)


# --- how pieces look -----------------------------------------------------------------------


class Level(IntEnum):
    """How strongly a piece of a formula holds together, loosest first."""

    SUM = 0
    RATIO = 1
    CROSS = 2
    PRODUCT = 3
    POWER = 4
    ATOM = 5


@dataclass(frozen=True)
class _Piece:
    text: str
    level: Level = Level.ATOM


class Notation(ABC):
    """How the pieces of a formula look; :data:`UNICODE` and :data:`LATEX` are the two."""

    minus: str
    cross: str
    dyad: str
    relations: ClassVar[Mapping[str, str]]
    constants: ClassVar[Mapping[Any, str]]

    def guard(self, piece: _Piece, level: Level) -> str:
        """`piece` as it stands where at least `level` is needed: in brackets if it is looser."""
        return piece.text if piece.level >= level else self.brackets(piece.text)

    @abstractmethod
    def brackets(self, inner: str) -> str:
        """(inner), also the scalar product when inner is "u, v"."""

    @abstractmethod
    def norm(self, inner: str) -> _Piece:
        """|inner|, the length of a vector or the absolute value of a scalar."""

    @abstractmethod
    def letter(self, letter: _Letter, bold: bool) -> _Piece:
        """A name."""

    @abstractmethod
    def number(self, value: sp.Float) -> _Piece:
        """A positive decimal number."""

    @abstractmethod
    def product(
        self,
        coefficient: tuple[int, int],
        above: Sequence[_Piece],
        below: Sequence[_Piece],
        vector: _Piece | None,
    ) -> _Piece:
        """(p/q) · above / below · vector."""

    @abstractmethod
    def power(self, base: _Piece, exponent: str) -> _Piece:
        """The exponent is a formula in this notation."""

    @abstractmethod
    def root(self, inner: _Piece) -> _Piece:
        """The square root."""

    @abstractmethod
    def call(self, function: str, arguments: Sequence[str], exponent: int = 1) -> _Piece:
        """A function of its arguments, raised to a power."""

    @abstractmethod
    def transpose(self, base: _Piece) -> _Piece:
        """The transposed tensor."""

    @abstractmethod
    def gradient(self, value: str, variable: str) -> _Piece:
        """∂value/∂variable."""

    @abstractmethod
    def quotient(self, above: str, below: str) -> _Piece:
        """A derivative: what is above the line and what is below, both written."""

    @abstractmethod
    def partial(self, name: str, order: int, above: bool = False) -> str:
        """∂²U above the line of a derivative, ∂x² below it."""

    @abstractmethod
    def matrix(self, rows: Sequence[Sequence[str]]) -> _Piece:
        """All entries, row by row."""

    @abstractmethod
    def fallback(self, formula: Any) -> str:
        """What the rules here do not cover."""


_RAISED = str.maketrans("0123456789-−", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁻")
_LOWERED = {
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
    constants: ClassVar[Mapping[Any, str]] = {sp.pi: "π", sp.E: "e"}

    def brackets(self, inner: str) -> str:
        return f"({inner})"

    def norm(self, inner: str) -> _Piece:
        return _Piece(f"|{inner}|")

    def letter(self, letter: _Letter, bold: bool) -> _Piece:
        base = _GREEK.get(letter.base, letter.base)
        marks = "".join(_ACCENTS[accent] for accent in letter.accents)
        if len(base) == 1 or not marks:
            head = unicodedata.normalize("NFC", base + marks)
        else:
            # an accent over a word would sit on its last letter
            head = "d" * len(letter.accents) + f"({base})" + "/dt" * len(letter.accents)
        sub = ",".join(_GREEK.get(part, part) for part in letter.subscript.split(","))
        if all(character in _LOWERED for character in sub):
            sub = "".join(_LOWERED[character] for character in sub)
        else:
            sub = f"_{sub}"
        return _Piece(head + "′″‴"[letter.primes - 1 : letter.primes] + sub)

    def number(self, value: sp.Float) -> _Piece:
        return _Piece(f"{float(value):.15g}")

    def product(
        self,
        coefficient: tuple[int, int],
        above: Sequence[_Piece],
        below: Sequence[_Piece],
        vector: _Piece | None,
    ) -> _Piece:
        p, q = coefficient
        factors = [self.guard(piece, Level.PRODUCT) for piece in above]
        if not below and coefficient in _FRACTIONS:
            factors.insert(0, _FRACTIONS[coefficient])
            p, q = 1, 1
        if p != 1 or not (factors or vector):
            factors.insert(0, str(p))
        divisors = [self.guard(piece, Level.POWER) for piece in below]
        if q != 1:
            divisors.insert(0, str(q))
        level = Level.PRODUCT
        if vector:
            factors.append(self.guard(vector, Level.CROSS))
            level = min(level, max(vector.level, Level.CROSS))
        head = " ".join(factors)
        if not divisors:
            return _Piece(head, level)
        tail = divisors[0] if len(divisors) == 1 else self.brackets(" ".join(divisors))
        return _Piece(f"{head} / {tail}", Level.RATIO)

    def power(self, base: _Piece, exponent: str) -> _Piece:
        head = self.guard(base, Level.ATOM)
        if re.fullmatch(r"−?\d+", exponent):
            return _Piece(head + exponent.translate(_RAISED), Level.POWER)
        simple = re.fullmatch(r"\w", exponent)
        return _Piece(f"{head}^{exponent if simple else self.brackets(exponent)}", Level.POWER)

    def root(self, inner: _Piece) -> _Piece:
        return _Piece(f"√{self.guard(inner, Level.ATOM)}", Level.POWER)

    def call(self, function: str, arguments: Sequence[str], exponent: int = 1) -> _Piece:
        raised = "" if exponent == 1 else str(exponent).translate(_RAISED)
        return _Piece(f"{function}{raised}({', '.join(arguments)})", Level.POWER)

    def transpose(self, base: _Piece) -> _Piece:
        return _Piece(self.guard(base, Level.ATOM) + "ᵀ", Level.POWER)

    def gradient(self, value: str, variable: str) -> _Piece:
        return _Piece(f"∂{value}/∂{variable}", Level.PRODUCT)

    def quotient(self, above: str, below: str) -> _Piece:
        return _Piece(f"{above}/{self.brackets(below) if ' ' in below else below}", Level.PRODUCT)

    def partial(self, name: str, order: int, above: bool = False) -> str:
        raised = "" if order == 1 else str(order).translate(_RAISED)
        return f"∂{raised}{name}" if above else f"∂{name}{raised}"

    def matrix(self, rows: Sequence[Sequence[str]]) -> _Piece:
        if all(len(row) == 1 for row in rows):
            return _Piece(f"({', '.join(row[0] for row in rows)})")
        return _Piece(f"[{'; '.join(', '.join(row) for row in rows)}]")

    def fallback(self, formula: Any) -> str:
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
    constants: ClassVar[Mapping[Any, str]] = {sp.pi: r"\pi", sp.E: "e"}

    #: A vector whose components take more characters is written as a column.
    _longest_list = 200

    _functions = frozenset({"sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "log", "exp"}) | {
        "arcsin",
        "arccos",
        "arctan",
    }

    def brackets(self, inner: str) -> str:
        return rf"\left({inner}\right)"

    def norm(self, inner: str) -> _Piece:
        return _Piece(rf"\left|{inner}\right|")

    def letter(self, letter: _Letter, bold: bool) -> _Piece:
        head = self._symbol(letter.base)
        if bold and letter.base in _GREEK:
            head = rf"\boldsymbol{{{head}}}"
        elif bold and len(letter.base) == 1:
            head = rf"\mathbf{{{head}}}"
        if len(letter.base) > 1 and letter.base not in _GREEK:
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
        return _Piece(head, Level.POWER if letter.primes else Level.ATOM)

    @staticmethod
    def _symbol(name: str) -> str:
        if name in _GREEK:
            return "o" if name == "omicron" else rf"\{name}"
        return name if len(name) == 1 or name.isdigit() else rf"\text{{{name}}}"

    def number(self, value: sp.Float) -> _Piece:
        mantissa, _, exponent = f"{float(value):.15g}".partition("e")
        if not exponent:
            return _Piece(mantissa)
        return _Piece(rf"{mantissa} \cdot 10^{{{int(exponent)}}}", Level.PRODUCT)

    def product(
        self,
        coefficient: tuple[int, int],
        above: Sequence[_Piece],
        below: Sequence[_Piece],
        vector: _Piece | None,
    ) -> _Piece:
        p, q = coefficient
        divisors = [str(q)] if q != 1 else []
        alone = len(below) == 1 and not divisors
        divisors += [self.guard(x, Level.SUM if alone else Level.PRODUCT) for x in below]
        first = [str(p)] if p != 1 else []
        # a bare rational coefficient stands before the factors, not above them
        lifted = bool(divisors) and (bool(below) or not (above or vector))
        alone = lifted and len(above) == 1 and not first
        factors = [self.guard(x, Level.SUM if alone else Level.PRODUCT) for x in above]
        level = Level.PRODUCT
        if lifted:
            head = [rf"\frac{{{' '.join(first + factors) or '1'}}}{{{' '.join(divisors)}}}"]
        elif divisors:
            head = [rf"\frac{{{p}}}{{{divisors[0]}}}", *factors]
        else:
            head = first + factors
        if vector:
            head.append(self.guard(vector, Level.CROSS))
            level = min(level, max(vector.level, Level.CROSS))
        return _Piece(" ".join(head) or "1", level)

    def power(self, base: _Piece, exponent: str) -> _Piece:
        return _Piece(f"{self.guard(base, Level.ATOM)}^{{{exponent}}}", Level.POWER)

    def root(self, inner: _Piece) -> _Piece:
        return _Piece(rf"\sqrt{{{inner.text}}}", Level.POWER)

    def call(self, function: str, arguments: Sequence[str], exponent: int = 1) -> _Piece:
        known = function in self._functions
        name = rf"\{function}" if known else rf"\operatorname{{{function}}}"
        raised = "" if exponent == 1 else f"^{{{exponent}}}"
        return _Piece(f"{name}{raised}{self.brackets(', '.join(arguments))}", Level.POWER)

    def transpose(self, base: _Piece) -> _Piece:
        return self.power(base, r"\top")

    def gradient(self, value: str, variable: str) -> _Piece:
        return _Piece(rf"\frac{{\partial {value}}}{{\partial {variable}}}", Level.PRODUCT)

    def quotient(self, above: str, below: str) -> _Piece:
        return _Piece(rf"\frac{{{above}}}{{{below}}}", Level.PRODUCT)

    def partial(self, name: str, order: int, above: bool = False) -> str:
        raised = "" if order == 1 else f"^{{{order}}}"
        return rf"\partial{raised} {name}" if above else rf"\partial {name}{raised}"

    def matrix(self, rows: Sequence[Sequence[str]]) -> _Piece:
        listed = r",\, ".join(row[0] for row in rows)
        if len(rows[0]) == 1 and len(listed) <= self._longest_list:
            return _Piece(self.brackets(listed))
        body = r" \\ ".join(" & ".join(row) for row in rows)
        return _Piece(rf"\begin{{pmatrix}} {body} \end{{pmatrix}}")

    def fallback(self, formula: Any) -> str:
        return str(sp.latex(formula))


UNICODE: Notation = _Unicode()
LATEX: Notation = _Latex()


# --- what a human would do -----------------------------------------------------------------

_FUNCTION_NAMES = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}

#: Mass and gravity stand first in a product: m g R.
_FIRST = {"m": 0, "g": 1}


def _weight(formula: Any) -> int:
    """The length of a term as the eye sees it, by which terms are ordered."""
    match formula:
        case sp.Number() | sp.NumberSymbol() | Diagonal() | Symmetric() | Identity():
            return 0
        case sp.Symbol() | Vector():
            return 1
        case Gradient():
            return 2
        case sp.Pow() if formula.exp.is_Integer:
            # a division is as long as a factor more
            power = int(formula.exp)
            return abs(power) * _weight(formula.base) + (power < 0)
        case sp.MatrixBase():
            return 1 + sum(map(_weight, formula))
    return sum(map(_weight, formula.args))


def _term_key(term: Any) -> tuple[int, int, bool, str]:
    """Short terms first; before them ½ (M, ω), and a negative number after all."""
    negative = _is_negative(term)
    place = 1
    if isinstance(term, sp.Number) and negative:
        place = 2
    elif isinstance(term, (sp.Mul, Dot)) and isinstance(term.as_coeff_Mul()[1], Dot):
        place = 1 if negative else 0
    return place, _weight(term), negative, str(sp.sstr(term))


def _is_negative(term: Any) -> bool:
    """Whether a term is written with a minus sign."""
    if isinstance(term, (sp.Add, MatAdd)):
        return all(map(_is_negative, term.args))
    if isinstance(term, sp.Number):
        return bool(term.is_negative)
    if isinstance(term, (sp.Mul, MatMul)):
        return sum(map(_is_negative, term.args)) % 2 == 1
    return False


def _negated(tensor: Any) -> Any:
    """Minus a vector or tensor, sums term by term."""
    if isinstance(tensor, MatAdd):
        return MatAdd(*(-1 * term for term in tensor.args))
    return -1 * tensor


def _ordered(terms: Iterable[Any]) -> list[Any]:
    """Terms in the order of `_term_key`, but a positive one at the head if there is one."""
    found = sorted(terms, key=_term_key)
    head = next((term for term in found if not _is_negative(term)), found[0])
    return [head, *(term for term in found if term is not head)]


def _common_fraction(formula: Any) -> sp.Rational:
    """The fraction that every term of a sum has for a number, which stands before brackets."""
    if not isinstance(formula, sp.Add):
        return sp.S.One
    shares = {abs(term.as_coeff_Mul()[0]) for term in formula.args}
    share = shares.pop()
    return share if not shares and share.is_Rational and share.q != 1 else sp.S.One


def _factor_key(factor: Any) -> tuple[int, int, str]:
    """Latin letters, Greek ones, derivatives; then scalar products, functions, roots, sums."""
    base = factor.base if isinstance(factor, sp.Pow) else factor
    if isinstance(base, sp.Symbol):
        letter = _letter(str(base))
        kind = 4 if letter.accents or letter.primes else 3 if letter.base in _GREEK else 2
        return 0, _FIRST.get(str(base), kind), str(base).casefold()
    rank = 3 if isinstance(base, sp.Add) else 1 if isinstance(base, Dot) else 2
    return 0 if base.is_number else rank, 0, str(sp.sstr(factor))


def _vector_of(symbols: Sequence[Any]) -> Vector | None:
    """The vector whose three components these are, if they are."""
    if len(symbols) < 3 or not isinstance(symbols[0], sp.Symbol):
        return None
    vector = Vector(str(symbols[0]).removesuffix("_1"))
    return vector if tuple(symbols) == vector.symbols else None


@dataclass(frozen=True)
class _Factors:
    negative: bool
    coefficient: tuple[int, int]
    above: tuple[Any, ...]
    below: tuple[Any, ...]
    tensors: tuple[Any, ...]


def _factors(formula: Any) -> _Factors:
    """A product taken apart."""
    if isinstance(formula, MatMul):
        scalar, tensors = formula.as_coeff_matrices()
    else:
        scalar, tensors = formula, ()
    negative = False
    coefficient = sp.S.One
    above: list[Any] = []
    below: list[Any] = []
    for signed in sp.Mul.make_args(scalar):
        minus = _is_negative(signed)
        negative ^= minus
        factor = -signed if minus else signed
        if isinstance(factor, sp.Rational):
            coefficient = coefficient * factor
        elif isinstance(factor, sp.Pow) and _is_negative(factor.exp):
            below.append(sp.Pow(factor.base, -factor.exp))
        else:
            above.append(factor)
    found = []
    for tensor in tensors:
        minus = _is_negative(tensor)
        negative ^= minus
        found.append(_negated(tensor) if minus else tensor)
    if len(found) > 1:
        found = [tensor for tensor in found if not isinstance(tensor, Identity)] or found[:1]
    return _Factors(
        negative,
        (int(coefficient.p), int(coefficient.q)),
        tuple(sorted(above, key=_factor_key)),
        tuple(sorted(below, key=_factor_key)),
        tuple(found),
    )


@dataclass(frozen=True)
class _Writer:
    """Writes formulas in a notation."""

    notation: Notation

    def piece(self, formula: Any) -> _Piece:
        """Any formula."""
        found = self.terms(formula)
        if len(found) == 1 and not found[0][0]:
            return found[0][1]
        written = ""
        for negative, term in found:
            body = self.notation.guard(term, Level.RATIO)
            if written:
                written += f" {self.notation.minus if negative else '+'} {body}"
            else:
                written = (self.notation.minus if negative else "") + body
        return _Piece(written, Level.SUM)

    def terms(self, formula: Any) -> list[tuple[bool, _Piece]]:
        """The terms of a sum in order, each with its sign; anything else is a single term."""
        share = _common_fraction(formula)
        if share != 1:
            rest = sp.Add(*(term / share for term in formula.args))
            return [self._product(_factors(sp.Mul(share, rest, evaluate=False)))]
        if isinstance(formula, (sp.Add, MatAdd)):
            return [self._term(term) for term in _ordered(formula.args)]
        return [self._term(formula)]

    def _term(self, formula: Any) -> tuple[bool, _Piece]:
        if isinstance(formula, (sp.Add, MatAdd)):
            return False, self.piece(formula)
        if isinstance(formula, sp.Float):
            return formula < 0, self.notation.number(abs(formula))
        if isinstance(formula, (sp.Mul, MatMul, sp.Rational)) or (
            isinstance(formula, sp.Pow) and _is_negative(formula.exp)
        ):
            return self._product(_factors(formula))
        return False, self._whole(formula)

    def _product(self, factors: _Factors) -> tuple[bool, _Piece]:
        above = [self.piece(factor) for factor in factors.above]
        below = [self.piece(factor) for factor in factors.below]
        vector = self._chain(factors.tensors) if factors.tensors else None
        if factors.coefficient == (1, 1) and not below:
            if vector and not above:
                return factors.negative, vector
            if len(above) == 1 and not vector:
                return factors.negative, above[0]
        if factors.coefficient[1] == 1 and not (above or below or vector):
            return factors.negative, _Piece(str(factors.coefficient[0]))
        written = self.notation.product(factors.coefficient, above, below, vector)
        return factors.negative, written

    def _chain(self, tensors: Sequence[Any]) -> _Piece:
        """Tensors and vectors one after the other; u ⊗ v for a column times a row."""
        for index, tensor in enumerate(tensors):
            if index and isinstance(tensor, Transpose) and tensor.arg.shape[1] == 1:
                left = self._chain(tensors[:index])
                right = self.piece(tensor.arg)
                guard = self.notation.guard
                dyad = self.notation.dyad.join(guard(x, Level.PRODUCT) for x in (left, right))
                piece = _Piece(dyad, Level.CROSS)
                rest = tensors[index + 1 :]
                return piece if not rest else self._beside(piece, self._chain(rest))
        pieces = [self.piece(tensor) for tensor in tensors]
        return pieces[0] if len(pieces) == 1 else self._beside(*pieces)

    def _beside(self, *pieces: _Piece) -> _Piece:
        return _Piece(
            " ".join(self.notation.guard(piece, Level.PRODUCT) for piece in pieces), Level.PRODUCT
        )

    def _whole(self, formula: Any) -> _Piece:
        """A formula that is neither a sum nor a product."""
        if isinstance(formula, (MatrixExpr, sp.MatrixBase)):
            return self._tensor(formula)
        notation = self.notation
        match formula:
            case sp.Symbol():
                return notation.letter(_letter(str(formula)), bold=False)
            case Dot():
                return self._dot(formula, 1)
            case sp.Pow():
                return self._power(formula)
            case sp.Abs():
                return notation.norm(self.piece(formula.args[0]).text)
            case Rate():
                return self._rate(formula)
            case sp.Derivative():
                return self._derivative(formula)
            case sp.Function():
                return self._function(formula, 1)
            case Relational():
                sides = (self.piece(side).text for side in formula.args)
                return _Piece(f" {notation.relations[formula.rel_op]} ".join(sides), Level.SUM)
        if formula in notation.constants:
            return _Piece(notation.constants[formula])
        return _Piece(notation.fallback(formula), Level.SUM)

    def _dot(self, product: Dot, exponent: int) -> _Piece:
        """(u, v), and u² or a power of it for (u, u)."""
        left, right = product.args
        if left == right:
            return self.notation.power(self.piece(left), str(2 * exponent))
        inside = ", ".join(self.piece(side).text for side in product.args)
        pair = _Piece(self.notation.brackets(inside))
        return pair if exponent == 1 else self.notation.power(pair, str(exponent))

    def _power(self, formula: sp.Pow) -> _Piece:
        base, exponent = formula.args
        whole = exponent.is_Integer
        if isinstance(base, Dot) and whole:
            return self._dot(base, int(exponent))
        if isinstance(base, Dot) and base.args[0] == base.args[1] and (2 * exponent).is_Integer:
            length = self.notation.norm(self.piece(base.args[0]).text)
            odd = int(2 * exponent)
            return length if odd == 1 else self.notation.power(length, str(odd))
        if exponent == sp.S.Half:
            return self.notation.root(self.piece(base))
        if isinstance(base, sp.Function) and not isinstance(base, (sp.Abs, Rate)) and whole:
            return self._function(base, int(exponent))
        written = f"{exponent.p}/{exponent.q}" if exponent.is_Rational else None
        if whole:
            written = str(exponent)
        return self.notation.power(self.piece(base), written or self.piece(exponent).text)

    def _function(self, formula: sp.Function, exponent: int) -> _Piece:
        name = str(formula.func.__name__)
        if isinstance(formula, AppliedUndef):
            head = self.notation.letter(_letter(name), bold=False).text
            written = f"{head}{self.notation.brackets(self._arguments(formula))}"
            piece = _Piece(written, Level.ATOM)
            return piece if exponent == 1 else self.notation.power(piece, str(exponent))
        arguments = [self.piece(argument).text for argument in formula.args]
        return self.notation.call(_FUNCTION_NAMES.get(name, name), arguments, exponent)

    def _rate(self, formula: Any) -> _Piece:
        """ẋ for a letter, d(…)/dt for a formula."""
        inner, times = formula, 0
        while isinstance(inner, Rate):
            inner, times = inner.args[0], times + 1
        if isinstance(inner, sp.Symbol) and times <= 2:
            letter = _letter(str(inner))
            for _ in range(times):
                letter = letter.dotted()
            return self.notation.letter(letter, bold=False)
        below = self.notation.power(_Piece("dt"), str(times)).text if times > 1 else "dt"
        above = self.notation.power(_Piece("d"), str(times)).text if times > 1 else "d"
        shown = self.notation.guard(self.piece(inner), Level.ATOM)
        return self.notation.quotient(f"{above} {shown}", below)

    def _derivative(self, formula: sp.Derivative) -> _Piece:
        """U′(x), U″(x) or ∂U/∂γ₁ of a function that is left open."""
        inner, order = formula.expr, sum(count for _, count in formula.variable_count)
        name = self.notation.letter(_letter(str(inner.func.__name__)), bold=False).text
        if len(inner.args) == 1 and order <= 3:
            letter = replace(_letter(str(inner.func.__name__)), primes=order)
            head = self.notation.letter(letter, bold=False).text
            return _Piece(f"{head}{self.notation.brackets(self._arguments(inner))}", Level.POWER)
        below = " ".join(
            self.notation.partial(self.piece(s).text, int(count))
            for s, count in formula.variable_count
        )
        return self.notation.quotient(self.notation.partial(name, order, above=True), below)

    def _arguments(self, formula: sp.Function) -> str:
        """Arguments of a function; a vector's components by the name of the vector."""
        listed = list(formula.args)
        shown = []
        while listed:
            whole = _vector_of(listed[:3])
            shown.append(self.piece(whole if whole is not None else listed[0]).text)
            listed = listed[3:] if whole is not None else listed[1:]
        return ", ".join(shown)

    def _tensor(self, formula: Any) -> _Piece:
        """A vector or tensor that is neither a sum nor a product."""
        notation = self.notation
        match formula:
            case Vector() | Diagonal() | Symmetric():
                return notation.letter(_letter(formula.name), bold=True)
            case Identity():
                return notation.letter(_Letter("E"), bold=True)
            case ZeroMatrix():
                return _Piece("0")
            case Cross():
                sides = (notation.guard(self.piece(x), Level.PRODUCT) for x in formula.args)
                return _Piece(notation.cross.join(sides), Level.CROSS)
            case Gradient():
                _, variable, name = formula.args
                return notation.gradient(self.piece(name).text, self.piece(variable).text)
            case Transpose():
                return notation.transpose(self.piece(formula.arg))
            case Inverse() | MatPow():
                base, exponent = formula.args
                minus = notation.minus if exponent < 0 else ""
                return notation.power(self.piece(base), f"{minus}{abs(exponent)}")
            case sp.MatrixBase():
                return self._components(formula)
        return _Piece(notation.fallback(formula), Level.SUM)

    def _components(self, matrix: sp.MatrixBase) -> _Piece:
        """A vector or tensor given by its entries."""
        rows, columns = matrix.shape
        entries = list(matrix)
        if columns == 1 and 1 in entries and entries.count(0) == rows - 1:
            return self.notation.letter(_letter(f"e_{entries.index(1) + 1}"), bold=True)
        if columns > 1 and matrix.is_diagonal():
            diagonal = [self.piece(matrix[i, i]).text for i in range(rows)]
            return self.notation.call("diag", diagonal)
        written = [[self.piece(matrix[i, j]).text for j in range(columns)] for i in range(rows)]
        return self.notation.matrix(written)
