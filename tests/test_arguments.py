"""Annotations with names that only type checkers import."""

from __future__ import annotations

import subprocess
import sys


def test_a_library_that_is_not_in_use_is_not_imported() -> None:
    lines = (
        "import sys",
        "from chaplygin.arguments import annotations_of",
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
