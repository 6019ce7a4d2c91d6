"""A planted error in any formula of the mechanics is seen by the comparison with the reference.

Each sign, factor, exponent and order of a vector product in the modules of formulas is changed in
turn, the package is rebuilt with the change, and the instants of a few bodies are compared with
the reference as in test_rolling.  A change that no comparison notices makes a test fail here,
unless it is listed below with the reason why it changes nothing.
"""

from __future__ import annotations

import ast
import sys
import types
from pathlib import Path

import pytest

import chaplygin
import chaplygin.errors
import chaplygin.statements
import chaplygin.system
import chaplygin.vectors
from mechanics.compare import (
    Package,
    begin,
    deviations,
    draw,
    equations,
    instant_of_package,
    instant_of_reference,
)

FOLDER = Path(chaplygin.__file__).parent / "mechanics"
CHANGED = ("attitude", "shapes", "contact", "rolling")
LOADED = ("surfaces", "shapes", "body", "contact", "attitude", "points", "rolling", "start")
SHARED = ("errors", "statements", "system", "vectors")

#: Bodies that between them use every formula, cheapest first.
BODIES = (
    ("ball", "plane", "marble"),
    ("ellipsoid", "inside", "rubber"),
    ("ball", "outside", "rubber"),
    ("ellipsoid", "plane", "marble"),
    ("torus", "outside", "marble"),
    ("revolution", "inside", "rubber"),
    ("implicit", "plane", "rubber"),
    ("implicit", "inside", "rubber"),
    ("disk", "plane", "rubber"),
    ("hollow ball", "outside", "marble"),
    ("ball centred", "plane", "marble"),
)

#: Changes that alter no motion, with the reason.
HARMLESS = {
    ("shapes", "2 * signed"): "a ball rolls by k = a/(a + R), which needs no trace",
    ("shapes", "lean - sp.Rational(str(FLAT)) ** 2"): "a threshold of 1e-12 beside 1",
    ("shapes", "sp.Rational(str(FLAT)) ** 2"): "a threshold of 1e-12 beside 1",
    ("shapes", "-16"): "where a profile is tried",
    ("shapes", "-9"): "where a profile is tried",
    ("shapes", "-2"): "where a profile is tried",
    ("shapes", "1e-09 * (1 + abs(sp.N(chi_1.subs({**table, u: cosine}))))"): "a tolerance",
    ("shapes", "1 + abs(sp.N(chi_1.subs({**table, u: cosine})))"): "a tolerance",
}

#: Functions that only look at input; their messages are tested elsewhere.
SPECTATORS = {"_check_ball", "_check_centre", "_check_potential", "_positive", "__post_init__"}


def sites(tree: ast.Module) -> list[ast.AST]:
    """The places of a module that can be changed, in order."""
    found: list[ast.AST] = []

    def visit(node: ast.AST) -> None:
        if isinstance(node, ast.FunctionDef) and node.name in SPECTATORS:
            return
        if _changeable(node):
            found.append(node)
        for child in ast.iter_child_nodes(node):
            visit(child)

    visit(tree)
    return found


def _changeable(node: ast.AST) -> bool:
    match node:
        case ast.BinOp(op=ast.Add() | ast.Sub()):
            return not any(isinstance(part, ast.JoinedStr) for part in ast.walk(node))
        case ast.BinOp(op=ast.Mult() | ast.Div() | ast.Pow()):
            return any(isinstance(side, ast.Constant) for side in (node.left, node.right))
        case ast.UnaryOp(op=ast.USub()):
            return True
        case ast.Call(func=ast.Name(id="cross")):
            return True
    return False


def change(node: ast.AST) -> ast.expr:
    """The changed form of a place."""
    match node:
        case ast.BinOp(op=ast.Add()):
            return ast.BinOp(node.left, ast.Sub(), node.right)
        case ast.BinOp(op=ast.Sub()):
            return ast.BinOp(node.left, ast.Add(), node.right)
        case ast.BinOp():
            grown = [
                ast.Constant(side.value + 1) if isinstance(side, ast.Constant) else side
                for side in (node.left, node.right)
            ]
            return ast.BinOp(grown[0], node.op, grown[1])
        case ast.UnaryOp():
            return node.operand
        case ast.Call():
            return ast.Call(node.func, node.args[::-1], node.keywords)
    raise TypeError(node)


class Planter(ast.NodeTransformer):
    """Puts a changed place into a tree."""

    def __init__(self, place: ast.AST) -> None:
        self.place = place

    def visit(self, node: ast.AST) -> ast.AST:
        return change(node) if node is self.place else super().visit(node)


def package(changed: str, tree: ast.Module) -> Package:
    """The mechanics rebuilt with one changed module."""
    for name in [name for name in sys.modules if name.split(".")[0] == "mutant"]:
        del sys.modules[name]
    for name in ("mutant", "mutant.mechanics"):
        module = types.ModuleType(name)
        module.__path__ = []
        sys.modules[name] = module
    for name in SHARED:
        sys.modules[f"mutant.{name}"] = sys.modules[f"chaplygin.{name}"]
    for name in LOADED:
        module = types.ModuleType(f"mutant.mechanics.{name}")
        module.__package__ = "mutant.mechanics"
        sys.modules[module.__name__] = module
        source = tree if name == changed else ast.parse((FOLDER / f"{name}.py").read_text())
        exec(compile(source, f"{name}.py", "exec"), module.__dict__)
    return Package(
        *(
            sys.modules[f"mutant.mechanics.{name}"]
            for name in ("body", "shapes", "surfaces", "rolling", "start")
        )
    )


@pytest.fixture(scope="module")
def cases():
    """The bodies, drawn once; those on a full tensor carry rotors and a potential."""
    return [draw(*names, "turned", seed=1, loaded=True) for names in BODIES]


def noticed(case, changed: Package) -> bool:
    """Whether a body tells the changed package from the reference."""
    try:
        system = equations(case, changed)
        placed, state = begin(case, system, changed)
        found = instant_of_package(system, state)
        expected = instant_of_reference(placed, system, state)
    except (ArithmeticError, TypeError, ValueError, AttributeError, KeyError, IndexError):
        return True
    return not max(deviations(found, expected).values()) < 1e-6


@pytest.mark.parametrize("name", CHANGED)
def test_every_planted_error_is_noticed(name, cases):
    source = (FOLDER / f"{name}.py").read_text()
    unnoticed = set()
    for number in range(len(sites(ast.parse(source)))):
        tree = ast.parse(source)
        place = sites(tree)[number]
        text = ast.unparse(place)
        tree = ast.fix_missing_locations(Planter(place).visit(tree))
        try:
            changed = package(name, tree)
        except TypeError:  # an operation that its operands do not have
            continue
        if not any(noticed(case, changed) for case in cases):
            unnoticed.add((name, text))
    assert unnoticed == {key for key in HARMLESS if key[0] == name}


def test_the_unchanged_package_agrees(cases):
    clean = package("", ast.Module([], []))
    assert not any(noticed(case, clean) for case in cases)
