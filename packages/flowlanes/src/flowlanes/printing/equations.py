"""Equations on a page of HTML: one below the other, in terms between which a line may break."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from .formula import signed_terms
from .mathml import FONT, mathml, width_of
from .notation import LATEX
from .poisson_brackets import Side

#: The style sheet of what `equations_html` writes. On a narrow screen the right side goes on below
#: the left one; what is still wider than the line is set smaller, by its width in em, ``--width``,
#: and scrolls where that does not suffice, with a shadow at the side on which there is more.
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
        Left sides in LaTeX, empty where there is none; right sides as formulas, whose sums are
        broken into lines between terms as the page is wide, or in LaTeX, which stay whole.

    Returns
    -------
    str
        A ``<div class="chaplygin-formula">``, for which `STYLE` has the rules.
    """
    rows = list(equations)
    has_names = any(left for left, _ in rows)
    body = "\n".join(f"<div>{_row(left, right, has_names)}</div>" for left, right in rows)
    return f'<div class="chaplygin-formula">{body}</div>'


def _row(left: str, right: sp.Basic | str, has_names: bool) -> str:
    first, *others = _terms(right)
    if has_names and not left:
        # a sign that goes on with the line above keeps its distance
        first = f"{{}} {first}"
    # braces keep a minus close to the term that it belongs to
    pieces = [rf"{{}} = {{{first}}}" if left else first, *others]
    cells = [f'<div class="right">{" ".join(map(_term, pieces))}</div>']
    if has_names:
        # on a narrow screen, where both sides are one paragraph, a line may break between them
        cells.insert(0, f'<div class="left">{_term(left) if left else ""}<wbr/></div>')
    return "".join(cells)


def _terms(right: sp.Basic | str) -> Sequence[str]:
    """The terms of a right side in LaTeX, each with its sign, which is set off from it."""
    if isinstance(right, str):
        return [right]
    (sign, first), *others = signed_terms(right, LATEX)
    return [f"{sign} {first}", *(rf"{sign} \; {term}" for sign, term in others)]


def _term(formula: str) -> str:
    """A term in MathML, with its width and with fractions of full size."""
    # words count as spaces beside which a sign keeps no distance, names do not
    written = mathml(formula).replace("<mtext>", "<mi>").replace("</mtext>", "</mi>")
    start = f'<math displaystyle="true" style="--width: {width_of(written):.0f}"'
    # the style sheet has the font
    return written.replace(f'<math style="{FONT}"', start, 1)
