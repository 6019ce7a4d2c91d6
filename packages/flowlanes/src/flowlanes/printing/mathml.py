"""Conversion of LaTeX to MathML for browsers."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from typing import Literal

#: Fonts with tall brackets and roots; most systems have one of them.
_FONTS = ("Latin Modern Math", "STIX Two Math", "Cambria Math", "DejaVu Math TeX Gyre")
#: The style of a formula.
FONT = "font-family: " + ", ".join([*(f"'{font}'" for font in _FONTS), "math"])


def mathml(formula: str, display: Literal["inline", "block"] = "inline") -> str:
    r"""Convert LaTeX to MathML that browsers display without scripts.

    Parameters
    ----------
    formula : str
        LaTeX for math mode, as produced by `latex` and `system_latex`; environments other than
        ``aligned`` and ``pmatrix`` are passed on unchanged.
    display : ``"inline"`` or ``"block"``
        Within a line of text, or on a separate line.

    Returns
    -------
    str
        One ``<math>`` element.
    """
    from latex2mathml.converter import convert

    # The converter aligns rows only in `split`, which looks the same.
    written = convert(re.sub(r"\{aligned\}", "{split}", formula), display=display)
    written = re.sub(
        r'<mi mathvariant="bold-italic">&#x([0-9A-F]+);</mi>', _bold_greek, str(written)
    )
    written = written.replace("<math ", f'<math style="{FONT}" ', 1)
    # As an operator, the name of a function would also be spaced from its argument; as an
    # identifier it needs a thin space after a preceding factor.
    written = re.sub(r"<mo>([a-z]{2,}\d?)</mo>", r"<mi>\1</mi>", written)
    written = re.sub(rf"({_FACTOR})(?=<mi>[a-z]{{2,}}\d?</mi>)", rf"\1{_THIN}", written)
    # Without this, a dot accent has the size of an exponent.
    written = written.replace("<mover>", '<mover accent="true">')
    # MathML Core leaves the alignment of columns to style sheets.
    style = r'style="text-align: \1; text-align: -webkit-\1; padding: 0.25em 0"'
    return re.sub(r'columnalign="(\w+)"', style, written)


#: Pattern of the end of a factor, and a thin space.
_FACTOR = r"</(?:mi|mn|msup|msub|msubsup|mfrac|mrow|msqrt|mover)>|(?:\)|&#x00029;)</mo>"
_THIN = '<mspace width="0.17em"/>'


def _bold_greek(match: re.Match[str]) -> str:
    """A bold Greek letter by its code point, since browsers ignore ``mathvariant``."""
    code = int(match[1], 16)
    if ord("α") <= code <= ord("ω"):
        code += ord("𝜶") - ord("α")
    elif ord("Α") <= code <= ord("Ω"):
        code += ord("𝜜") - ord("Α")
    return f"<mi>&#x{code:05X};</mi>"


#: Width in em of a letter or figure, and of a sign with its spacing.
_LETTER = 0.66
_SIGN = 1.4
#: Relative size of indices and exponents, and of fractions within a line.
_SCRIPT = 0.7


def width_of(text: str) -> float:
    """Approximate width of a ``<math>`` element, in em of its font.

    Letters are counted: a fraction has the width of its wider part, scripts add to their base.
    """
    return _width(ElementTree.fromstring(text))


def _width(node: ElementTree.Element) -> float:
    name = node.tag.rpartition("}")[2]
    parts = [_width(child) for child in node]
    match name:
        case "mi" | "mn" | "mtext" | "mo":
            text = node.text or ""
            sign = name == "mo" and text not in "()[]{}|,"
            return _SIGN if sign else _LETTER * len(text)
        case "mspace":
            return float((node.get("width") or "0").removesuffix("em") or 0.0)
        case "mfrac":
            return max(parts, default=0.0) + 0.2
        case "msub" | "msup":
            return parts[0] + _SCRIPT * sum(parts[1:])
        case "msubsup":
            return parts[0] + _SCRIPT * max(parts[1:])
        case "mover" | "munder" | "munderover":
            return max(parts)
        case "msqrt" | "mroot":
            return sum(parts) + 0.8
        case "mtable":
            rows = [[_width(cell) for cell in row] for row in node]
            columns = [
                max(row[i] for row in rows if i < len(row)) for i in range(max(map(len, rows)))
            ]
            return sum(columns) + 0.8 * (len(columns) - 1)
        case _:
            return sum(parts)
