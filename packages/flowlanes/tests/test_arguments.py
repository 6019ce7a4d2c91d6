"""Annotations with names that only type checkers import."""

from __future__ import annotations

import ast
import inspect
import subprocess
import sys
from importlib import import_module

import pytest

from flowlanes.arguments import _imports_for_type_checkers


def test_a_library_that_is_not_in_use_is_not_imported() -> None:
    lines = (
        "import sys",
        "from flowlanes.arguments import annotations_of",
        "from typing import TYPE_CHECKING, Any",
        "module = type(sys)('late')",
        "assert 'colorsys' not in sys.modules",
        "from chaplygin import arguments",
        "def function(a: 'late.Thing | int', b: 'int'): ...",
        "sys.modules['late'] = module",
        "arguments._imports_for_type_checkers = lambda module: {'late': ('colorsys', '')}",
        "hints = annotations_of(function, ['late'], {})",
        "print('colorsys' in sys.modules, hints['b'].__name__)",
    )
    result = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)], capture_output=True, text=True, check=False
    )
    assert result.stderr == ""
    assert result.stdout == "False int\n"


@pytest.mark.parametrize("name", ["sympy.core.expr", "flowlanes.flow.sections.poincare_map"])
def test_imports_for_type_checkers_are_those_of_the_whole_module(name: str) -> None:
    module = import_module(name)
    expected = [
        item.asname or item.name
        for block in ast.parse(inspect.getsource(module)).body
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"
        for statement in block.body
        if isinstance(statement, ast.Import | ast.ImportFrom)
        for item in statement.names
    ]
    assert expected
    assert list(_imports_for_type_checkers(module)) == list(dict.fromkeys(expected))
