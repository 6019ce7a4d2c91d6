"""Formulas as MathML, made when the site is built, so that a page needs no script for them."""

from __future__ import annotations

import re
from typing import Any

from docutils import nodes
from program import program_digest

from flowlanes.printing.mathml import mathml


def _inline(writer: Any, node: nodes.math) -> None:
    writer.body.append(mathml(node.astext()))
    raise nodes.SkipNode


def _display(writer: Any, node: nodes.math_block) -> None:
    formula, number = re.fullmatch(r"(.*?)(?:\\tag\{(.*)\}\s*)?", node.astext(), re.S).groups()
    written = mathml(formula, "block")
    if number:
        written += f'<span class="number">({number})</span>'
    writer.body.append(f'<div class="formula">{written}</div>')
    raise nodes.SkipNode


def setup(app: Any) -> dict[str, Any]:
    """Write formulas in place of Sphinx's own choice of a script from the network."""
    app.add_html_math_renderer("mathml", (_inline, None), (_display, None))
    app.config.html_math_renderer = "mathml"
    app.add_config_value("program", program_digest(), "env", str)
    return {"version": "1", "parallel_read_safe": True}
