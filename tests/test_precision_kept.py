"""Whatever is called, the precision of mpmath and of FLINT is afterwards what it was before."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path

import flint
import mpmath
import pytest

from borisov_mamaev_2008.obstructions.limit_cycle import displacement
from chaplygin import invariant_measure, solve
from flowlanes.system.vectors import real_symbol
from lawproof import prove_all
from lawproof.search import integrals, search_space
from nonholonomic import nonholonomy
from nonholonomic.catalogue import from_catalogue
from nonholonomic.mechanics.lagrangian.mechanism import Mechanism, coordinates
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.mechanics.reduction.chaplygin import chaplygin_form
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball
from workspace import files, nodes_of

x, y, phi = (real_symbol(name) for name in ("x", "y", "phi"))


def settings() -> tuple[int, ...]:
    return (mpmath.mp.prec, mpmath.mp.dps, mpmath.iv.prec, flint.ctx.prec, flint.ctx.dps)


def rolling() -> RollingBody:
    return RollingBody(Body(1.0, (1.0, 1.5, 2.1), Ball(1.0)), contact="rubber")


def knife() -> Mechanism:
    frame = coordinates(x, y, phi)
    xdot, ydot, phidot = frame.w
    energy = (xdot**2 + ydot**2 + phidot**2) / 2
    return Mechanism("knife", frame, energy, (ydot - x * phidot,))


CALLS: dict[str, Callable[[], object]] = {
    "limit cycle": lambda: displacement(Fraction(13, 5), upwards=True, steps=20),
    "equations": lambda: equations_of_motion(knife()),
    "measure of a mechanism": lambda: invariant_measure(knife()),
    "measure of a body": lambda: invariant_measure(rolling()),
    "nonholonomy": lambda: nonholonomy(knife()),
    "reduction": lambda: chaplygin_form(knife()),
    "proof": lambda: prove_all(from_catalogue("chaplygin-sleigh-reduced"))[:1],
    "search": lambda: next(
        integrals(search_space(from_catalogue("chaplygin-sleigh-reduced"), degree=2))
    ),
    "closed form": lambda: solve(from_catalogue("lagrange-top"), (1, 2, 3, 0, 0.6, 0.8)).states(
        [1.0]
    ),
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
@pytest.mark.parametrize("bits", [53, 77])
def test_precision_is_kept(call: Callable[[], object], bits: int) -> None:
    with mpmath.workprec(bits), flint.ctx.workprec(bits):
        before = settings()
        call()
        assert settings() == before


def test_precision_is_kept_where_something_is_refused() -> None:
    before = settings()
    with pytest.raises(ArithmeticError, match="exceeds its assumed bound"):
        displacement(Fraction(13, 5), upwards=True, steps=2)
    assert settings() == before


def _assigned(path: Path) -> Iterator[tuple[str, int]]:
    """Assignments to the precision of a context that the module did not make itself."""
    own = {
        target.id
        for node in nodes_of(path, ast.Assign)
        if isinstance(node.value, ast.Call) and ast.unparse(node.value.func).endswith("MPContext")
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    for node in nodes_of(path, ast.Assign, ast.AugAssign):
        for target in node.targets if isinstance(node, ast.Assign) else [node.target]:
            if isinstance(target, ast.Attribute) and target.attr in ("prec", "dps"):
                base = ast.unparse(target.value)
                if base not in own:
                    yield base, node.lineno


def test_no_module_sets_the_precision_of_others() -> None:
    found = {f"{path.name}:{line}: {base}" for path in files() for base, line in _assigned(path)}
    assert not found
