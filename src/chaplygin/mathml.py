"""LaTeX as MathML that browsers show without help."""

from __future__ import annotations

import re
from typing import Literal

__all__ = ["mathml"]

#: Fonts with tall brackets and roots, one of which most systems have.
_FONTS = ("Latin Modern Math", "STIX Two Math", "Cambria Math", "DejaVu Math TeX Gyre")


def mathml(formula: str, display: Literal["inline", "block"] = "inline") -> str:
    r"""LaTeX as MathML that browsers show without help.

    Parameters
    ----------
    formula : str
        LaTeX for math mode, as :func:`latex` and :func:`system_latex` write it; other
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
    fonts = ", ".join(f"'{font}'" for font in _FONTS)
    written = written.replace("<math ", f'<math style="font-family: {fonts}, math" ', 1)
    # a function's name is no operator, which would keep its distance
    written = re.sub(r"<mo>([a-z]{2,}\d?)</mo>", r"<mi>\1</mi>", written)
    # without this, a dot is as small as an exponent
    written = written.replace("<mover>", '<mover accent="true">')
    # browsers follow MathML Core, which leaves the alignment of columns to style sheets
    style = r'style="text-align: \1; text-align: -webkit-\1; padding: 0.25em 0"'
    return re.sub(r'columnalign="(\w+)"', style, written)


def _bold_greek(match: re.Match[str]) -> str:
    """A bold Greek letter by its own code point, since browsers ignore ``mathvariant``."""
    code = int(match[1], 16)
    if ord("α") <= code <= ord("ω"):
        code += ord("𝜶") - ord("α")
    elif ord("Α") <= code <= ord("Ω"):
        code += ord("𝜜") - ord("Α")
    return f"<mi>&#x{code:05X};</mi>"
