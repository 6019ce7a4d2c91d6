"""LaTeX as MathML that browsers show without help."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from typing import Literal

#: Fonts with tall brackets and roots, one of which most systems have.
_FONTS = ("Latin Modern Math", "STIX Two Math", "Cambria Math", "DejaVu Math TeX Gyre")
#: The style of a formula.
FONT = "font-family: " + ", ".join([*(f"'{font}'" for font in _FONTS), "math"])


def mathml(formula: str, display: Literal["inline", "block"] = "inline") -> str:
    r"""LaTeX as MathML that browsers show without help.

    Parameters
    ----------
    formula : str
        LaTeX for math mode, as `latex` and `system_latex` write it; other
        environments than ``aligned`` and ``pmatrix`` are passed on as they are.
    display : ``"inline"`` or ``"block"``
        In a line of text or on a line of its own.

    Returns
    -------
    str
        One ``<math>`` element.
    """
    from latex2mathml.converter import convert

    # the converter aligns rows in `split` alone, which looks the same
    written = convert(re.sub(r"\{aligned\}", "{split}", formula), display=display)
    written = re.sub(
        r'<mi mathvariant="bold-italic">&#x([0-9A-F]+);</mi>', _bold_greek, str(written)
    )
    written = written.replace("<math ", f'<math style="{FONT}" ', 1)
    # a function's name is no operator, which would keep its distance from its argument too; a
    # factor before it is set off by a thin space
    written = re.sub(r"<mo>([a-z]{2,}\d?)</mo>", r"<mi>\1</mi>", written)
    written = re.sub(rf"({_FACTOR})(?=<mi>[a-z]{{2,}}\d?</mi>)", rf"\1{_THIN}", written)
    # without this, a dot is as small as an exponent
    written = written.replace("<mover>", '<mover accent="true">')
    # browsers follow MathML Core, which leaves the alignment of columns to style sheets
    style = r'style="text-align: \1; text-align: -webkit-\1; padding: 0.25em 0"'
    return re.sub(r'columnalign="(\w+)"', style, written)


#: The end of a factor, and a thin space.
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


#: Width in em of what takes no letters, and of a letter, figure or sign with what is about it.
_LETTER = 0.66
_SIGN = 1.4
#: Size of indices and exponents, and of what stands in a fraction within a line.
_SCRIPT = 0.7


def width_of(text: str) -> float:
    """About how wide a ``<math>`` element is, in em of its own font.

    Counted by letters: fractions are as wide as their wider half, scripts stand beside their base.
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
