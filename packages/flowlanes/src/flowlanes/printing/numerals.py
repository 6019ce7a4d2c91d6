"""Numbers and units in print notation, with superscripts and a proper minus sign."""

from __future__ import annotations

import re

MINUS = "\N{MINUS SIGN}"
SUPERSCRIPTS = str.maketrans("0123456789-" + MINUS, "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁻")

#: A hyphen used as a minus sign: before a number, or between spaces.
_SIGN = re.compile(r"(?<![\w)\]-])-(?=[\d.(]|[∞π√])|(?<= )-(?= )")
#: A number with a power of ten in computer notation.
_POWER = re.compile(r"(?<![\w.])(-?\d+(?:\.\d+)?)e([+-]?\d+)\b")


def number(value: float, digits: int = 10) -> str:
    """A number with the given number of digits: ``0``, ``−2.5``, ``1.8 × 10⁻¹⁵``."""
    return typographic_signs(f"{value + 0.0:.{digits}g}")


def typographic_signs(text: str) -> str:
    """A text with the signs and powers of ten of its numbers in print notation."""

    def power(match: re.Match[str]) -> str:
        exponent = str(int(match[2])).translate(SUPERSCRIPTS)
        return f"{match[1]} × 10{exponent}"

    return _SIGN.sub(MINUS, _POWER.sub(power, text))


def unit(text: str) -> str:
    """A unit with superscripts: ``kg² m⁴`` for ``kg^2 m^4`` or ``kg**2*m**4``.

    An exponent that is not an integer is left unchanged: ``kg^0.5``.
    """
    raised = re.sub(
        r"(?:\^|\*\*)\{?(-?\d+)(?![\d.])\}?", lambda match: match[1].translate(SUPERSCRIPTS), text
    )
    return raised.replace("*", " ")
