"""Names in code, parsed into letters, accents and indices."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass

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


#: Quantities of a contact with friction, whose names consist of several words.
CONTACT_NAMES = {
    "slip_speed": SymbolName("u"),
    "slip_floor": SymbolName("epsilon", subscript="u"),
    "rolling_speed": SymbolName("omega", subscript="t"),
    "rolling_floor": SymbolName("epsilon", subscript="t"),
    "spin_sign": SymbolName("sigma", subscript="n"),
    "spin_arm": SymbolName("mu", subscript="s"),
    "mu_static": SymbolName("mu", subscript="0"),
    "normal_rate": SymbolName("b", primes=1, subscript="n"),
    "normal_rate_free": SymbolName("b", subscript="n"),
    "normal_response": SymbolName("B", subscript="n"),
    "force_share": SymbolName("F", subscript="u"),
    "couple_share": SymbolName("M", subscript="n"),
    "spin_rate": SymbolName("b", subscript="s"),
    "holding_couple": SymbolName("tau"),
}


#: Vectors whose names are words, with their letters, also used for their components.
WORDS = {"attitude": "q", "position": "x"}


def letter_of(name: str) -> SymbolName:
    """The letter for a name in code."""
    if name in CONTACT_NAMES:
        return CONTACT_NAMES[name]
    if name.startswith("work_"):
        return SymbolName("W", subscript=name.removeprefix("work_"))
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
        return SymbolName(WORDS.get(base, base), subscript=subscript)
    if accent.startswith("prime"):
        return SymbolName(base, primes=int(primes or 1), subscript=subscript)
    return SymbolName(base, (accent,), subscript=subscript)
