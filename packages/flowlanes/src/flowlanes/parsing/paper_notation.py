"""Convert formulas from paper notation, ``θ₃²``, to code notation, ``theta_3**2``."""

from __future__ import annotations

import re
import unicodedata

_PLAIN = str.maketrans(
    {
        **{chr(0x2080 + i): f"_{i}" for i in range(10)},
        **dict(zip("²³⁴⁵⁶⁷⁸⁹", (f"**{i}" for i in range(2, 10)), strict=True)),
        "−": "-",
        "·": "*",
        "⋅": "*",
    }
)
_GREEK = re.compile(r"GREEK (SMALL|CAPITAL) LETTER (\w+)")


def code_spelling(text: str) -> str:
    """A text with Greek letters, indices, powers and signs converted to code notation."""
    return text if text.isascii() else "".join(map(_word, text.translate(_PLAIN)))


def _word(character: str) -> str:
    match = _GREEK.fullmatch(unicodedata.name(character, ""))
    if match is None:
        return character
    word = match[2].lower().replace("lamda", "lambda")
    return word if match[1] == "SMALL" else word.capitalize()
