"""Equations as HTML, one below the other, with line breaks between terms."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from .formula import signed_terms
from .mathml import FONT, mathml, width_of
from .notation import LATEX
from .poisson_brackets import Side

#: The style sheet for `equations_html`. On a narrow screen the right side continues below the left
#: one. Wide terms get a smaller font, according to their width in em, ``--width``, and scroll if
#: that is not enough, with a shadow on the side where more follows.
STYLE = (
    ".chaplygin-formula math { "
    + FONT
    + " }"
    + """
.chaplygin-formula { display: grid; grid-template-columns: max-content minmax(0, 1fr);
  align-items: baseline; margin: 0.4em 0 0.4em 1.5em; }
.chaplygin-formula > div { display: contents; }
.chaplygin-formula .left { text-align: right; white-space: nowrap; }
.chaplygin-formula .right { padding: 0.22em 0 0.22em 1.3em; text-indent: -1.3em;
  overflow: auto hidden; line-height: 1.3; break-inside: avoid; }
.chaplygin-formula .right:first-child { grid-column: 1 / -1; }
.chaplygin-formula math { font-size: clamp(0.58em, calc(42em / var(--width)), 1.04em); }
@media screen {
  .chaplygin-formula, .chaplygin-formula .right { --page: var(--paper, Canvas);
    --shadow: rgb(128 128 128 / 0.5); background:
    linear-gradient(90deg, var(--page) 40%, transparent)
    -2px -2px / 2.4em calc(100% + 4px) no-repeat local,
    linear-gradient(270deg, var(--page) 40%, transparent)
    calc(100% + 2px) -2px / 2.4em calc(100% + 4px) no-repeat local,
    linear-gradient(90deg, var(--shadow), transparent) 1px 0 / 0.7em 100% no-repeat scroll,
    linear-gradient(270deg, var(--shadow), transparent) calc(100% - 1px) 0 / 0.7em 100%
    no-repeat scroll; }
}
@media screen and (max-width: 620px) {
  .chaplygin-formula { display: block; margin-left: 0; overflow: auto hidden; }
  .chaplygin-formula .right { background: none; }
  .chaplygin-formula > div { display: block; padding-left: 1.3em; text-indent: -1.3em;
    margin: 0.35em 0; line-height: 1.5; }
  .chaplygin-formula .left, .chaplygin-formula .right { display: inline; padding: 0; }
  .chaplygin-formula math { font-size: clamp(0.6em, calc(17.8em / var(--width)), 1em); }
}
@media print {
  .chaplygin-formula, .chaplygin-formula .right { overflow: visible; }
  .chaplygin-formula math { font-size: min(1.04em, calc(52em / var(--width))); }
}"""
)


def equations_html(equations: Iterable[Side]) -> str:
    """Equations as a displayed formula in HTML.

    Parameters
    ----------
    equations : iterable of (str, formula or str)
        Left sides in LaTeX, possibly empty; right sides as formulas, whose sums are broken into
        lines between terms to fit the page, or in LaTeX, which are not broken.

    Returns
    -------
    str
        A ``<div class="chaplygin-formula">``, to be used with `STYLE`.
    """
    rows = list(equations)
    has_names = any(left for left, _ in rows)
    body = "\n".join(f"<div>{_row(left, right, has_names)}</div>" for left, right in rows)
    return f'<div class="chaplygin-formula">{body}</div>'


def _row(left: str, right: sp.Basic | str, has_names: bool) -> str:
    first, *others = _terms(right)
    if has_names and not left:
        # A sign that continues the line above keeps its spacing.
        first = f"{{}} {first}"
    # Braces keep a leading minus close to its term.
    pieces = [rf"{{}} = {{{first}}}" if left else first, *others]
    cells = [f'<div class="right">{" ".join(map(_term, pieces))}</div>']
    if has_names:
        # On a narrow screen both sides form one paragraph, with a possible line break between
        # them.
        cells.insert(0, f'<div class="left">{_term(left) if left else ""}<wbr/></div>')
    return "".join(cells)


def _terms(right: sp.Basic | str) -> Sequence[str]:
    """The terms of a right side in LaTeX, each with its sign and spacing."""
    if isinstance(right, str):
        return [right]
    (sign, first), *others = signed_terms(right, LATEX)
    return [f"{sign} {first}", *(rf"{sign} \; {term}" for sign, term in others)]


def _term(formula: str) -> str:
    """A term in MathML, with its width and full-size fractions."""
    # A sign next to <mtext> loses its spacing, next to <mi> it does not.
    written = mathml(formula).replace("<mtext>", "<mi>").replace("</mtext>", "</mi>")
    start = f'<math displaystyle="true" style="--width: {width_of(written):.0f}"'
    # The style sheet sets the font.
    return written.replace(f'<math style="{FONT}"', start, 1)
