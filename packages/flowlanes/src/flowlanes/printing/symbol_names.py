"""Names in code, parsed into letters, accents and indices."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass

from ..displays import letters

GREEK = {
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
GREEK.pop("lamda", None)

_NAME = re.compile(
    r"(?P<base>[^\W\d_]+?)(?P<accent>ddot|dot|tilde|hat|bar|prime(?P<primes>\d?))?"
    r"(?P<number>\d*)(?:_(?P<sub>\w+))?"
)


@dataclass(frozen=True)
class SymbolName:
    """The parts of a name in code: ``rdot_1`` is r with a dot and subscript 1."""

    base: str
    accents: tuple[str, ...] = ()
    primes: int = 0
    subscript: str = ""

    def rate(self) -> SymbolName:
        """The name of the time derivative."""
        accents = (*self.accents, "dot")
        if accents[-2:] == ("dot", "dot"):
            accents = (*accents[:-2], "ddot")
        return SymbolName(self.base, accents, self.primes, self.subscript)


@dataclass(frozen=True)
class WordLetters:
    """Letters of quantities whose names in code are words.

    Parameters
    ----------
    names : mapping of str to SymbolName
        Whole names: ``slip_speed`` may be u.
    vectors : mapping of str to str
        Vectors, with the letter that their components have as well: ``position_x`` may be xₓ.
    prefixes : mapping of str to str
        Beginnings of names, of which the rest is an index: ``work_1`` may be W₁.
    """

    names: Mapping[str, SymbolName]
    vectors: Mapping[str, str]
    prefixes: Mapping[str, str]


def _registered() -> list[WordLetters]:
    return [words for words in letters() if isinstance(words, WordLetters)]


def letter_of(name: str) -> SymbolName:
    """The letter that a name in code spells."""
    registered = _registered()
    for words in registered:
        if name in words.names:
            return words.names[name]
        for prefix, letter in words.prefixes.items():
            if name.startswith(prefix):
                return SymbolName(letter, subscript=name.removeprefix(prefix))
    match = _NAME.fullmatch(name)
    if match is None:
        return SymbolName(name)
    base, accent, primes, number, sub = match.group("base", "accent", "primes", "number", "sub")
    if len(base) > 1 and base not in GREEK and sub and sub.isalpha() and len(sub) > 1:
        # Two words are not a letter with an index.
        return SymbolName(name)
    parts = [part for part in (number, *(sub or "").split("_")) if part]
    subscript = ",".join(parts)
    if accent is None:
        vectors = (words.vectors[base] for words in registered if base in words.vectors)
        return SymbolName(next(vectors, base), subscript=subscript)
    if accent.startswith("prime"):
        return SymbolName(base, primes=int(primes or 1), subscript=subscript)
    return SymbolName(base, (accent,), subscript=subscript)
