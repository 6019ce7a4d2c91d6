"""A System as plain text for a terminal, as LaTeX, and as HTML with MathML.

Formulas are formatted by :mod:`flowlanes.printing.formula`; its functions :func:`text` and
:func:`latex` are also available here.
"""

from __future__ import annotations

import html
import re
import textwrap
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from ..system.named_formulas import Pairs
from .equations import STYLE, equations_html
from .formula import latex, rate, signed_terms, text, width
from .laws import caption, equation, equation_sides
from .mathml import mathml
from .notation import LATEX, UNICODE, Notation
from .numerals import number, unit
from .poisson_brackets import Side
from .system_layout import Layout, layout, reconstruction_layout

if TYPE_CHECKING:
    from ..system.laws import Integral, Law
    from ..system.system import System


#: Line length of terminal output, and of a displayed equation.
WIDTH = 100
LINE = 84

_INDENT = "    "


# --- plain text ----------------------------------------------------------------------------


def system_line(system: System) -> str:
    """A system in one line: name, variables, numbers of parameters and laws."""
    counts = (("parameter", len(system.parameters)), ("law", len(system.laws)))
    numbers = ", ".join(f"{n} {word}{'' if n == 1 else 's'}" for word, n in counts)
    return f"<System {system.name}: {', '.join(map(str, system.state))}; {numbers}>"


def system_text(system: System) -> str:
    """A system for a terminal, at most 100 columns wide.

    Returns
    -------
    str
        Title and summary, equations of motion, definitions, phase space, parameters, laws and
        source.
    """
    page = layout(system)
    blocks = [[system.title, *_paragraph(system.summary)]]
    blocks.append(["Equations of motion", *_field_lines(page)])
    if page.where:
        blocks[-1] += ["where", *_equations(_text_pairs(page.where))]
    if system.relations:
        sides = [tuple(map(text, equation(zero))) for zero in system.relations]
        blocks[-1] += ["on the phase space", *_equations(sides)]
    if system.parameters:
        rows = [
            (text(p.symbol), number(p.default), unit(p.unit), p.meaning) for p in system.parameters
        ]
        blocks.append(["Parameters", *_table(rows)])
    blocks += _law_blocks(system)
    if system.source:
        blocks.append([f"Source: {system.source}"])
    return "\n\n".join("\n".join(block) for block in blocks)


def laws_text(system: System) -> str:
    """The laws of a system as in `system_text`; empty if there are none."""
    return "\n\n".join("\n".join(block) for block in _law_blocks(system))


def _law_blocks(system: System) -> list[list[str]]:
    """The laws, and the definitions that they need."""
    blocks = []
    if system.integrals:
        laws = [row for law in system.integrals for row in _law_rows(law, system)]
        blocks.append(["Constant along the motion", *_table(laws)])
    blocks += [_law_lines(law, system) for law in _other_laws(system)]
    if further := layout(system).further:
        blocks.append(["In the laws", *_equations(_text_pairs(further))])
    return blocks


def field_text(system: System) -> list[str]:
    """The equations of motion as indented lines of at most 100 columns."""
    return _field_lines(layout(system))


def motion_text(system: System) -> list[str]:
    """The equations of the lift to space, as indented lines; empty without a lift."""
    page = reconstruction_layout(system)
    return _field_lines(page) + _equations(_text_pairs(page.where))


def _field_lines(page: Layout) -> list[str]:
    return _equations((rate(name, UNICODE), text(formula)) for name, formula in page.field)


def _text_pairs(pairs: Pairs) -> list[tuple[str, str]]:
    return [(text(name), text(formula)) for name, formula in pairs]


def _paragraph(words: str) -> list[str]:
    return textwrap.wrap(words, WIDTH)


def _equations(sides: Iterable[tuple[str, ...]]) -> list[str]:
    lines: list[str] = []
    for left, right in sides:
        head = f"{_INDENT}{left} = "
        lines += _wrapped_lines(head, right)
    return lines


def _law_rows(law: Integral, system: System) -> list[tuple[str, str]]:
    return [(law.name, text(law.value)), ("", caption(law, system, text))]


def _other_laws(system: System) -> list[Law]:
    """The laws other than integrals."""
    return [law for law in system.laws if law not in system.integrals]


def _law_lines(law: Law, system: System) -> list[str]:
    """A law of any kind: heading, equations and caption."""
    lines = [law.heading]
    for left, right in equation_sides(law, system, UNICODE):
        head = f"{_INDENT}{left} = " if left else _INDENT * 2
        lines += _wrapped_lines(head, right if isinstance(right, str) else text(right))
    wrapped = textwrap.wrap(caption(law, system, text), WIDTH - 4)
    return [*lines, *(textwrap.indent(line, _INDENT) for line in wrapped)]


def _table(rows: Sequence[tuple[str, ...]]) -> list[str]:
    """A table with minimal column widths, whose last column is wrapped."""
    columns = [max(map(width, column)) for column in zip(*rows, strict=True)][:-1]
    lines: list[str] = []
    for *cells, last in rows:
        padded = (
            cell + " " * (size - width(cell)) for cell, size in zip(cells, columns, strict=True)
        )
        lines += _wrapped_lines(_INDENT + "".join(f"{cell}  " for cell in padded), last)
    return lines


def _wrapped_lines(head: str, formula: str) -> list[str]:
    """`head` and a formula, wrapped at the best places below the start of the formula."""
    lines = []
    indent = " " * width(head)
    while width(head) + width(formula) > WIDTH:
        cut = _best_break(formula, WIDTH - width(head))
        if cut is None:
            break
        lines.append(head + formula[:cut])
        head, formula = indent, formula[cut + 1 :]
    return [*lines, (head + formula).rstrip()]


def _best_break(formula: str, limit: int) -> int | None:
    """The best space for a line break within `limit` columns: outside brackets, before ±."""
    best: tuple[float, int] | None = None
    depth = 0
    used = 0
    for index, character in enumerate(formula):
        used += width(character)
        if used > limit + 1:
            break
        depth += (character in "([") - (character in ")]")
        if character != " " or index == 0:
            continue
        before, after = formula[index - 1], formula[index + 1 : index + 2]
        if after in "+−":
            cost = 0.0
        elif before in ";,":
            cost = -0.5 if before == ";" else 0.5
        elif before in "+−×⊗/" or after in "×⊗/":
            cost = 8.0
        else:
            cost = 4.0
        if best is None or depth + cost <= best[0]:
            best = (depth + cost, index)
    return best[1] if best else None


# --- LaTeX ---------------------------------------------------------------------------------


def system_latex(system: System) -> str:
    r"""The equations of motion and their definitions, as an ``aligned`` environment.

    Returns
    -------
    str
        LaTeX for math mode; long sums are broken into several lines.
    """
    page = layout(system)
    rows = _aligned_rows((rate(name, LATEX), formula) for name, formula in page.field)
    if page.where:
        rows.append(r"\text{where} \quad &")
        rows += _aligned_rows((latex(name), formula) for name, formula in page.where)
    return _aligned_environment(rows)


def _aligned_environment(rows: Sequence[str]) -> str:
    return "\\begin{aligned}\n" + " \\\\\n".join(rows) + "\n\\end{aligned}"


def _aligned_rows(sides: Iterable[tuple[str, sp.Basic]]) -> list[str]:
    rows = []
    for left, formula in sides:
        first, *others = _sum_lines(formula, LATEX)
        rows.append(f"{left} &= {first}")
        rows += [rf"&\quad {{}} {line}" for line in others]
    return rows


def _sum_lines(formula: sp.Basic, notation: Notation) -> list[str]:
    """A sum as lines of about `LINE` columns."""
    lines: list[str] = []
    used = 0
    measured = signed_terms(formula, UNICODE)
    for (sign, term), (_, plain) in zip(signed_terms(formula, notation), measured, strict=True):
        signed = f"{sign} {term}".strip()
        if lines and used + width(plain) <= LINE:
            lines[-1] += f" {signed}"
            used += width(plain) + 3
        else:
            lines.append(signed)
            used = width(plain)
    return lines


# --- HTML ----------------------------------------------------------------------------------

_STYLE = (
    """\
<style>
.chaplygin-system table { border-collapse: collapse; margin: 0.3em 0 0.8em; }
.chaplygin-system th, .chaplygin-system td
  { padding: 0.15em 0.8em 0.15em 0; text-align: left; vertical-align: baseline; }
.chaplygin-system th { font-weight: normal; opacity: 0.8; }
"""
    + STYLE
    + "\n</style>"
)


def system_html(system: System) -> str:
    """A system as a self-contained HTML fragment with MathML.

    Returns
    -------
    str
        One ``<section class="chaplygin-system">`` with title, equations, definitions, phase space,
        parameters, laws and source.
    """
    page = layout(system)
    parts = [_STYLE, f"<h3>{html.escape(system.title)}</h3>"]
    if system.summary:
        parts.append(f"<p>{html.escape(system.summary)}</p>")
    parts += ["<h4>Equations of motion</h4>", equations_html(_rates(page.field))]
    if page.where:
        parts += ["<p>where</p>", equations_html(_definitions(page.where))]
    if system.relations:
        sides = [equation(zero) for zero in system.relations]
        parts += ["<p>on the phase space</p>", equations_html(_definitions(sides))]
    if system.parameters:
        parts += ["<h4>Parameters</h4>", _parameter_table(system)]
    if system.integrals:
        parts += ["<h4>Constant along the motion</h4>", _law_table(system)]
    parts += [law_html(law, system) for law in _other_laws(system)]
    if page.further:
        parts += ["<h4>In the laws</h4>", equations_html(_definitions(page.further))]
    if system.source:
        parts.append(f"<p>Source: {html.escape(system.source)}</p>")
    return '<section class="chaplygin-system">\n' + "\n".join(parts) + "\n</section>"


def motion_html(system: System) -> str:
    """The equations of the lift to space as HTML; empty without a lift."""
    page = reconstruction_layout(system)
    return equations_html([*_rates(page.field), *_definitions(page.where)]) if page.field else ""


def law_html(law: Law, system: System) -> str:
    """A law of any kind as HTML: heading, equations in MathML, caption."""
    sides = equation_sides(law, system, LATEX)
    parts = [f"<h4>{html.escape(law.heading)}</h4>", equations_html(sides)]
    sentence = _caption_html(law, system)
    if sentence:
        parts.append(f'<p class="caption">{sentence}</p>')
    return "\n".join(parts)


def claims_html(system: System) -> str:
    """All laws of a system with the definitions that they need; empty if there are none."""
    parts = [law_html(law, system) for law in system.laws]
    further = layout(system).further
    if parts and further:
        parts += ["<h4>In the laws</h4>", equations_html(_definitions(further))]
    return "\n".join(parts)


def law_latex(law: Law, system: System) -> str:
    """The equations of a law as an ``aligned`` environment; an integral as a single formula."""
    if law in system.integrals:
        return latex(law.value)
    return _aligned_environment(_law_rows_latex(law, system))


def _law_rows_latex(law: Law, system: System) -> list[str]:
    rows = []
    for left, right in equation_sides(law, system, LATEX):
        if isinstance(right, str):
            rows.append(f"{left} &= {right}" if left else rf"&\quad {right}")
        else:
            rows += _aligned_rows([(left, right)])
    return rows


def _caption_html(law: Law, system: System) -> str:
    """The caption of a law with the formulas of its level in MathML."""
    formulas: list[str] = []

    def mark(formula: sp.Basic) -> str:
        formulas.append(mathml(latex(formula)))
        return f"\0{len(formulas) - 1}\0"

    sentence = html.escape(caption(law, system, mark))
    return re.sub(r"\0(\d+)\0", lambda match: formulas[int(match[1])], sentence)


def _rates(pairs: Pairs) -> list[Side]:
    return [(rate(name, LATEX), formula) for name, formula in pairs]


def _definitions(pairs: Iterable[tuple[sp.Basic, sp.Basic]]) -> list[Side]:
    return [(latex(name), formula) for name, formula in pairs]


def _html_table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    head = "".join(f"<th>{cell}</th>" for cell in header)
    body = "\n".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table>\n<tr>{head}</tr>\n{body}\n</table>"


def _parameter_table(system: System) -> str:
    return _html_table(
        ("symbol", "default", "unit", "meaning"),
        (
            (
                mathml(latex(p.symbol)),
                number(p.default),
                html.escape(unit(p.unit)),
                html.escape(p.meaning),
            )
            for p in system.parameters
        ),
    )


def _law_table(system: System) -> str:
    rows = (
        (html.escape(law.name), mathml(latex(law.value)), _caption_html(law, system))
        for law in system.integrals
    )
    return _html_table(("name", "formula", "meaning"), rows)
