r"""LaTeX as one line of Unicode, for a terminal: ``\frac{1}{2}(\mathbf M, \theta)`` is ½(M, θ).

:mod:`flowlanes.printing.formula` formats SymPy formulas; this module converts formulas given in
LaTeX, such as ``\frac{1}{2}(\mathbf M, \theta)`` to ½(M, θ), by the same conventions.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass

from .symbol_names import GREEK

_SYMBOLS = {
    "varphi": "φ",
    "varepsilon": "ε",
    "varkappa": "ϰ",
    "partial": "∂",
    "nabla": "∇",
    "infty": "∞",
    "sum": "Σ",
    "prod": "Π",
    "int": "∫",
    "dots": "…",
}
_RELATIONS = {
    "ne": "≠",
    "neq": "≠",
    "ge": "≥",
    "geq": "≥",
    "le": "≤",
    "leq": "≤",
    "in": "∈",
    "to": "→",
    "rightarrow": "→",
    "leftrightarrow": "↔",
}
_BETWEEN = {"times": "×", "otimes": "⊗", "cdot": "·", "wedge": "∧"}
_FUNCTIONS = frozenset(
    {"sin", "cos", "tan", "cot", "sinh", "cosh", "log", "exp", "det", "dim", "ctg"}
)
_FONTS = frozenset({"mathbf", "boldsymbol", "mathrm", "text", "operatorname"})
_ACCENTS = {
    "dot": "\N{COMBINING DOT ABOVE}",
    "ddot": "\N{COMBINING DIAERESIS}",
    "tilde": "\N{COMBINING TILDE}",
    "hat": "\N{COMBINING CIRCUMFLEX ACCENT}",
    "bar": "\N{COMBINING MACRON}",
    "overline": "\N{COMBINING MACRON}",
}
_SCRIPT = {"B": "ℬ", "E": "ℰ", "F": "ℱ", "H": "ℋ", "I": "ℐ", "L": "ℒ", "M": "ℳ", "R": "ℛ"}
_SUPERSCRIPTS = dict(zip("0123456789+−=()ijknmT′*", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁱʲᵏⁿᵐᵀ′*", strict=True))
_SUBSCRIPTS = dict(
    zip("0123456789+−=()aehijklmnoprstuvx,", "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ,", strict=True)
)
_HALVES = {("1", "2"): "½", ("1", "3"): "⅓", ("2", "3"): "⅔", ("1", "4"): "¼", ("3", "4"): "¾"}

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\s+|.", flags=re.S)
_FORMULA = re.compile(r"\$\$(.+?)\$\$|\$(.+?)\$", flags=re.S)


@dataclass(frozen=True)
class _Part:
    r"""A piece of a line with its kind.

    The kinds are ``letter`` (a factor), ``open`` and ``close`` (brackets), ``function``,
    ``relation`` (with spaces around), ``sign`` (plus or minus), ``between`` (a multiplication
    sign), ``bar``, ``comma``, ``space``, ``index``, ``ratio`` (from ``\frac``) and ``rate`` (a
    derivative).
    """

    text: str
    kind: str = "letter"


def plain_words(words: str) -> str:
    """A sentence with LaTeX formulas between dollar signs, as text for a terminal.

    Emphasis between asterisks is removed, and L_k in running text gets a subscript; script letters
    look the same as in formulas.
    """
    shown = _FORMULA.sub(lambda match: plain(match[1] or match[2]), words)
    shown = re.sub(r"(?<!\w)\*(\w[^*]*)\*", r"\1", shown).translate(_BOLD_SCRIPT)
    return re.sub(
        r"(?<=[\w\u0300-\u036f])_([0-9a-z]+)(?!\w)", lambda match: _small("_", match[1]), shown
    )


def plain(formula: str) -> str:
    r"""A formula in LaTeX as one line of Unicode.

    Parameters
    ----------
    formula : str
        LaTeX for math mode, without environments.

    Returns
    -------
    str
        Accents are combining characters, indices and exponents are small characters if Unicode has
        them; an unknown command is replaced by its name.
    """
    reader = _Reader([token for token in _TOKEN.findall(formula) if not token.isspace()])
    return unicodedata.normalize("NFC", _line(reader.parts()))


class _Reader:
    """Parser of a sequence of tokens."""

    def __init__(self, tokens: Sequence[str]) -> None:
        self._tokens = list(tokens)
        self._at = 0

    def parts(self) -> list[_Part]:
        """All parts up to the end of a group."""
        parts: list[_Part] = []
        while self._at < len(self._tokens) and self._tokens[self._at] != "}":
            token = self._next()
            if token in ("_", "^"):
                parts.append(_Part(_small(token, _line(self._argument())), "index"))
            else:
                parts += self._meaning(token)
        return parts

    def _next(self) -> str:
        token = self._tokens[self._at]
        self._at += 1
        return token

    def _argument(self) -> list[_Part]:
        """A group in braces, or the single following part."""
        if self._at == len(self._tokens):
            return []
        token = self._next()
        if token != "{":
            return self._meaning(token)
        parts = self.parts()
        self._at += 1
        return parts

    def _meaning(self, token: str) -> list[_Part]:
        if token == "{":
            self._at -= 1
            return self._argument()
        if not token.startswith("\\"):
            return [_character(token)]
        return self._command(token[1:])

    def _command(self, name: str) -> list[_Part]:
        if name in ("left", "right"):
            return []
        if name in ("{", "}", "|"):
            kinds = {"{": ("{", "open"), "}": ("}", "close"), "|": ("‖", "bar")}
            return [_Part(*kinds[name])]
        if name in (",", ";", " ", "quad"):
            return [_Part(" ", "space")]
        if name == "frac":
            return [_fraction(self._argument(), self._argument())]
        if name == "sqrt":
            return [_Part(f"√{_in_brackets(_line(self._argument()))}")]
        if name in _ACCENTS:
            return [_accented_letter(_line(self._argument()), name)]
        if name in ("mathcal", "mathbb"):
            return [_Part("".join(map(_ALPHABETS[name], _line(self._argument()))))]
        if name in _FONTS:
            inner = self._argument()
            word = _line(inner)
            known = name == "operatorname" or word in _FUNCTIONS
            return [_Part(word, "function")] if known else inner
        if name in _FUNCTIONS:
            return [_Part(name, "function")]
        if name == "pm":
            return [_Part("±", "sign")]
        if name in _RELATIONS:
            return [_Part(_RELATIONS[name], "relation")]
        if name in _BETWEEN:
            return [_Part(_BETWEEN[name], "between")]
        return [_Part(_SYMBOLS.get(name) or GREEK.get(name, name))]


def _character(token: str) -> _Part:
    if token in "([":
        return _Part(token, "open")
    if token in ")]":
        return _Part(token, "close")
    if token in "+-":
        return _Part("−" if token == "-" else token, "sign")
    if token in "=<>":
        return _Part(token, "relation")
    if token in ",;:":
        return _Part(token, "comma")
    if token == "/":
        return _Part(token, "between")
    return _Part("′" if token == "'" else token)


def _script(letter: str) -> str:
    if not ("A" <= letter <= "Z"):
        return letter
    return _SCRIPT.get(letter) or chr(ord("𝒜") + ord(letter) - ord("A"))


#: Bold script capitals in running text, mapped to the script of formulas.
_BOLD_SCRIPT = {ord("𝓐") + i: _script(chr(ord("A") + i)) for i in range(26)}


def _double(letter: str) -> str:
    return {"R": "ℝ", "Z": "ℤ", "C": "ℂ"}.get(letter, letter)


_ALPHABETS = {"mathcal": _script, "mathbb": _double}


def _accented_letter(letter: str, accent: str) -> _Part:
    """A letter with its accent; longer formulas in brackets."""
    marks = sum(map(unicodedata.combining, letter)) > 0
    if len(letter) == 1 or marks:
        return _Part(letter + _ACCENTS[accent])
    if accent in ("dot", "ddot"):
        power = "" if accent == "dot" else "²"
        return _Part(f"d{power}({letter})/dt{power}")
    return _Part(f"({letter}){_ACCENTS[accent]}")


def _small(place: str, text: str) -> str:
    """An index or exponent: in small characters if possible, otherwise after its sign."""
    table = _SUBSCRIPTS if place == "_" else _SUPERSCRIPTS
    packed = text.replace(" ", "")
    if all(character in table for character in packed):
        return "".join(table[character] for character in packed)
    return place + (text if len(text) == 1 else f"({text})")


def _loose(text: str) -> bool:
    """True if a formula needs brackets as a factor: it has a sign or space outside brackets."""
    depth = 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        if depth == 0 and character in " +−=/×⊗·∧":
            return True
    return False


def _in_brackets(text: str) -> str:
    """The text in brackets, unless it is a letter, f(…), or bracketed already."""
    if re.fullmatch(r"\w?\(.*\)", text) and _one_pair(text[text.index("(") :]):
        return text
    base = re.sub(r"[₀-₉ₐ-ₜᵢᵣᵤᵥⱼ⁰¹²³⁴-⁹⁻′]", "", unicodedata.normalize("NFC", text))
    if len([c for c in base if not unicodedata.combining(c)]) <= 1 or base.isdigit():
        return text
    return f"({text})"


def _one_pair(text: str) -> bool:
    """True if the first bracket is closed by the last character."""
    depth = 0
    for index, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if depth == 0:
            return index == len(text) - 1
    return False


def _fraction(above: Sequence[_Part], below: Sequence[_Part]) -> _Part:
    first, second = _line(above), _line(below)
    if (first, second) in _HALVES:
        return _Part(_HALVES[first, second])
    sign = second[:1]
    if sign in ("d", "∂") and first.startswith(sign) and " " not in first + second:
        return _Part(f"{first}/{second}", "rate")
    top = f"({first})" if _loose(first) else first
    return _Part(f"{top}/{_in_brackets(second)}", "ratio")


def _line(parts: Sequence[_Part]) -> str:
    """Parts as one line, with the usual spaces."""
    written = ""
    before: _Part | None = None
    for index, part in enumerate(parts):
        after = parts[index + 1] if index + 1 < len(parts) else None
        if part.kind == "relation" or (part.kind == "sign" and _follows_a_term(before)):
            written = f"{written.rstrip()} {part.text} "
        elif part.kind == "comma":
            written = f"{written.rstrip()}{part.text} "
        elif part.kind == "space":
            written += "" if written.endswith((" ", "(")) else " "
        elif part.kind == "function":
            gap = " " if before is not None and before.kind in _FACTORS else ""
            tail = " " if after is not None and after.kind not in ("open", "index") else ""
            written += f"{gap}{part.text}{tail}"
        elif part.kind == "rate":
            gap = " " if before is not None and before.kind in _FACTORS else ""
            tail = " " if after is not None and after.kind in _FOLLOWING else ""
            written += f"{gap}{part.text}{tail}"
        elif part.kind == "ratio" and _is_factor(before, after):
            written += f"({part.text})"
        else:
            written += f"{' ' if _apart(parts, index) else ''}{part.text}"
        before = part
    return re.sub(" +", " ", written).strip()


#: Kinds that end a factor, and kinds that begin one.
_FACTORS = ("letter", "index", "close", "ratio", "rate", "function")
_FOLLOWING = ("letter", "open", "ratio", "rate", "function")


def _follows_a_term(before: _Part | None) -> bool:
    """True if a sign connects two terms, rather than being the sign of a number."""
    return before is not None and before.kind in _FACTORS


def _is_factor(before: _Part | None, after: _Part | None) -> bool:
    """True if a quotient has neighbours that could be read as part of it."""
    return (before is not None and before.kind in (*_FACTORS, "between")) or (
        after is not None and after.kind in (*_FOLLOWING, "index", "between")
    )


def _apart(parts: Sequence[_Part], index: int) -> bool:
    """True if a letter needs a space before it: sin² θ, cos θ φ̇, ρ_μ M."""
    if index < 1 or parts[index].kind not in ("letter", "ratio"):
        return False
    before = parts[index - 1]
    if before.kind == "index" and before.text[0] in "_^":
        return True
    return before.kind in ("index", "letter") and index >= 2 and parts[index - 2].kind == "function"
