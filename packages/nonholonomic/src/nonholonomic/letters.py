"""The letters of quantities of mechanics whose names in code are words."""

from __future__ import annotations

from flowlanes.printing.symbol_names import SymbolName, WordLetters

#: Quantities of a contact with friction, whose names are words with indices that are words.
_CONTACT = {
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

LETTERS = WordLetters(
    names=_CONTACT,
    vectors={"attitude": "q", "position": "x"},
    prefixes={"work_": "W"},
)
