"""The example with the bifurcation diagrams of the documentation."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from nonholonomic.closed_form.bifurcation import bifurcation_diagram, locate

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    sys.path.insert(0, str(EXAMPLES))
    try:
        import bifurcation_diagrams

        yield bifurcation_diagrams
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.mark.slow
def test_pictures_and_tables(example, tmp_path, capsys):
    example.main(tmp_path)
    assert {path.stem for path in tmp_path.iterdir()} == set(example.SHOWN)
    said = capsys.readouterr().out
    assert "permanent rotation about axis 2, 2, unstable" in said
    assert "region 3: 4 tori, z_1 in [r, r], z_2 in [e2, e3]; ν_1 keeps its sign" in said


@pytest.mark.slow
def test_marked_motions_lie_among_tori(example):
    for name, state in example.SHOWN.values():
        diagram = bifurcation_diagram(name)
        symbols = diagram.plane.system.symbols
        assert diagram.region(*locate(diagram, dict(zip(symbols, state, strict=True)))).tori
