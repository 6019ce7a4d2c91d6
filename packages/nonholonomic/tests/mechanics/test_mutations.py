"""A planted error in any formula of the mechanics is seen by the comparison with the reference.

Each sign, factor, constant, exponent and order of a vector product in the modules of formulas is
changed in turn, the package is rebuilt with the change, and the instants of the bodies that use
the formula are compared with the reference as in test_rolling.  A change that no comparison
notices makes a test fail here, unless it is listed below with the reason why it changes nothing.
"""

from __future__ import annotations

import ast
import copy
import sys
import types
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import nonholonomic
from flowlanes.system.system import System
from flowlanes.system.vectors import to_components
from mechanics.compare import (
    GAMMA,
    Package,
    begin,
    deviations,
    draw,
    equations,
    instant_of_package,
    instant_of_reference,
    worst,
)
from spread import spread

FOLDER = Path(nonholonomic.__file__).parent / "mechanics"


def package_of(module: str) -> str:
    """The package in which a module of the mechanics is."""
    return "shapes" if (FOLDER / "shapes" / f"{module}.py").exists() else "rolling"


#: Those with formulas.
CHANGED = (
    "attitude",
    "surfaces",
    "shape_base",
    "revolution",
    "implicit",
    "shapes",
    "equations",
)
LOADED = (
    "kinds",
    "kinematics",
    "rays",
    "gauss_map",
    "surfaces",
    "shape_base",
    "revolution",
    "implicit",
    "shapes",
    "cavity",
    "cavity_fit",
    "inertia",
    "fluid",
    "body",
    "contact",
    "attitude",
    "contact_models",
    "equations",
    "initial_state",
)

#: Changes are tried in so many parts, of which one is no slow test.
PARTS = 10

#: Bodies that between them use every formula, cheapest first.
BODIES = (
    ("ball", "plane", "marble"),
    ("ball", "outside", "rubber"),
    ("ellipsoid", "inside", "rubber"),
    ("ellipsoid", "plane", "marble"),
    ("torus", "outside", "marble"),
    ("disk", "plane", "rubber"),
    ("revolution", "inside", "rubber"),
    ("hollow ball", "outside", "marble"),
    ("ball centred", "plane", "marble"),
    ("implicit", "plane", "rubber"),
    ("implicit", "inside", "rubber"),
)

_PROFILE = "revolution.ShapeOfRevolution.from_profile"
_SIZE = "1 + abs(sp.N(chi_1.subs(here)))"

#: Changes that alter no motion, with the reason.
HARMLESS = {
    "shapes.Ball.signed_radius: -self.radius -> self.radius": (
        "the equations take the Gauss map, and ask of the radius only whether there is one"
    ),
    **dict.fromkeys(
        (
            "shapes.Ball.gauss: 2 * signed -> 2",
            "shapes.Ball.gauss: 2 * signed -> signed",
            "shapes.Ball.gauss: 2 * signed -> (2 + 1) * signed",
        ),
        "a ball rolls by k = a/(a + R) and needs no trace",
    ),
    **dict.fromkeys(
        (
            "surfaces.Sphere.swing: slip / radius -> slip",
            "surfaces.Sphere.swing: slip / radius -> slip * radius",
            "surfaces.Sphere.swing: cross(gamma, omega) + slip / radius"
            " -> cross(gamma, omega) - slip / radius",
        ),
        "nothing slips here; motions with friction on spheres have references of their own",
    ),
    **dict.fromkeys(
        (
            f"{_PROFILE}: -16 -> 16",
            f"{_PROFILE}: -9 -> 9",
            f"{_PROFILE}: -2 -> 2",
            f"{_PROFILE}: sp.Rational(n, 17) -> sp.Rational(n + 1, 17)",
            f"{_PROFILE}: sp.Rational(n, 17) -> sp.Rational(n, 17 + 1)",
        ),
        "any points will do to try a profile",
    ),
    **dict.fromkeys(
        (
            f"{_PROFILE}: {_SIZE} -> 1 - abs(sp.N(chi_1.subs(here)))",
            f"{_PROFILE}: {_SIZE} -> 1 + {_SIZE}",
            f"{_PROFILE}: 1e-09 * ({_SIZE}) -> (1e-09 + 1) * ({_SIZE})",
            f"{_PROFILE}: 1e-09 * ({_SIZE}) -> {_SIZE}",
            f"{_PROFILE}: 1e-09 * ({_SIZE}) -> 1e-09",
        ),
        "how much rounding is allowed to a profile; test_shapes tells a right from a wrong one",
    ),
}

#: Functions that only look at input, whose messages are tested elsewhere, and those that the
#: equations of a rolling body do not use: how far a body reaches, its closed form and its drawing,
#: and what surfaces that are neither plane nor sphere have.
SPECTATORS = {
    "require_known",
    "_require_room",
    "centre_outside",
    "heights",
    "_half_breadth",
    "axial_symmetry",
    "equation",
    "refusal_of_normal",
    "_through_spread",
    "_points",
    "check_centre",
    "_check_potential",
    "_positive",
    "require_positive",
    "__post_init__",
}


# ---------------------------------------------------------------------------------------------
# Changes


@dataclass(frozen=True)
class Change:
    """A place in a module, by its number in the order of `ast.walk`, and what takes its place."""

    module: str
    function: str
    place: int
    old: str
    new: str

    def tree(self) -> ast.Module:
        """The module with the change made."""
        tree = parsed(self.module)
        target = list(ast.walk(tree))[self.place]
        replacement = ast.parse(self.new, mode="eval").body
        return ast.fix_missing_locations(_Replace(target, replacement).visit(tree))


class _Replace(ast.NodeTransformer):
    def __init__(self, target: ast.AST, replacement: ast.expr) -> None:
        self.target, self.replacement = target, replacement

    def visit(self, node: ast.AST) -> ast.AST:
        return self.replacement if node is self.target else super().visit(node)


def parsed(module: str) -> ast.Module:
    return ast.parse((FOLDER / package_of(module) / f"{module}.py").read_text())


def changes(module: str) -> list[Change]:
    """Every change of a module's formulas."""
    tree = parsed(module)
    number = {node: i for i, node in enumerate(ast.walk(tree))}
    return [
        Change(module, function, number[node], ast.unparse(node), ast.unparse(new))
        for function, node in formulas(tree, "")
        for new in variants(node)
    ]


def formulas(node: ast.AST, function: str) -> Iterator[tuple[str, ast.AST]]:
    """All expressions outside annotations and spectators, with the function they stand in."""
    if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
        if node.name in SPECTATORS:
            return
        function = f"{function}.{node.name}".lstrip(".")
    if isinstance(node, ast.FunctionDef):
        children: list[ast.AST] = [*node.body]
    elif isinstance(node, ast.AnnAssign):
        children = [node.value] if node.value else []
    elif isinstance(node, ast.JoinedStr):
        children = []
    else:
        children = [*ast.iter_child_nodes(node)]
    yield function, node
    for child in children:
        yield from formulas(child, function)


def variants(node: ast.AST) -> Iterator[ast.expr]:
    """What an expression may be changed into."""
    match node:
        case ast.BinOp(op=ast.Add() | ast.Sub()) if not _is_text(node):
            other = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
            yield ast.BinOp(node.left, other, node.right)
        case ast.BinOp(op=ast.Mult()):
            yield from (node.left, node.right)
        case ast.BinOp(op=ast.Div()):
            yield node.left
            yield ast.BinOp(node.left, ast.Mult(), node.right)
        case ast.BinOp(op=ast.Pow()):
            yield node.left
            yield ast.BinOp(node.left, ast.Pow(), ast.BinOp(node.right, ast.Add(), ast.Constant(1)))
        case ast.UnaryOp(op=ast.USub()):
            yield node.operand
        case ast.Call(func=ast.Name(id="cross"), args=[left, right]):
            yield ast.Call(node.func, [right, left], [])
        case ast.Call(func=ast.Attribute(attr="Rational"), args=[first, second]):
            for pair in ([_next(first), second], [first, _next(second)]):
                yield ast.Call(node.func, pair, [])
    if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub, ast.Mult)):
        if isinstance(node.left, ast.Constant) and not _is_text(node):
            yield ast.BinOp(_next(node.left), node.op, node.right)
        if isinstance(node.right, ast.Constant) and not _is_text(node):
            yield ast.BinOp(node.left, node.op, _next(node.right))


def _is_text(node: ast.AST) -> bool:
    return any(
        isinstance(part, ast.JoinedStr)
        or (isinstance(part, ast.Constant) and isinstance(part.value, str))
        for part in ast.walk(node)
    )


def _next(node: ast.expr) -> ast.expr:
    return ast.BinOp(copy.copy(node), ast.Add(), ast.Constant(1))


def named(found: list[Change]) -> dict[str, Change]:
    """Changes by a name that does not depend on where in its function one stands."""
    seen: Counter[str] = Counter()
    table = {}
    for change in found:
        name = f"{change.module}.{change.function}: {change.old} -> {change.new}"
        seen[name] += 1
        table[name if seen[name] == 1 else f"{name} ({seen[name]})"] = change
    return table


# ---------------------------------------------------------------------------------------------
# The changed package


@cache
def code(module: str) -> types.CodeType:
    """A module that notes in ``CALLED`` which of its functions are called."""
    tree = parsed(module)
    _note_calls(tree, "")
    return compile(ast.fix_missing_locations(tree), f"{module}.py", "exec")


def _note_calls(node: ast.AST, function: str) -> None:
    if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
        function = f"{function}.{node.name}".lstrip(".")
    for child in ast.iter_child_nodes(node):
        _note_calls(child, function)
    if isinstance(node, ast.FunctionDef):
        node.body[:0] = ast.parse(f"CALLED.add((__name__, {function!r}))").body


def package(change: Change | None, used: set[tuple[str, str]]) -> Package:
    """The mechanics rebuilt, with one change or none; notes in `used` what is called."""
    for name in [name for name in sys.modules if name.split(".")[0] == "mutant"]:
        del sys.modules[name]
    for name in (
        "mutant",
        "mutant.mechanics",
        "mutant.mechanics.rolling",
        "mutant.mechanics.shapes",
    ):
        module = types.ModuleType(name)
        module.__path__ = []
        sys.modules[name] = module
    for name in ("conventions", "rotations"):
        sys.modules[f"mutant.mechanics.{name}"] = import_module(f"nonholonomic.mechanics.{name}")
    for name in LOADED:
        module = types.ModuleType(f"mutant.mechanics.{package_of(name)}.{name}")
        module.__package__ = f"mutant.mechanics.{package_of(name)}"
        module.CALLED = used
        sys.modules[module.__name__] = module
        changed = change is not None and name == change.module
        exec(compile(change.tree(), f"{name}.py", "exec") if changed else code(name), vars(module))
    return Package(
        *(
            sys.modules[f"mutant.mechanics.{package_of(name)}.{name}"]
            for name in (
                *("body", "shapes", "surfaces", "equations", "initial_state"),
                *("revolution", "implicit"),
            )
        )
    )


# ---------------------------------------------------------------------------------------------
# Comparisons


#: What a changed formula may raise; warnings of NumPy are errors here.
FAILURES = (
    *(ArithmeticError, TypeError, ValueError, AttributeError, KeyError, IndexError),
    RuntimeWarning,
)


class Witness:
    """A body that may notice a change in one of the functions that it uses."""

    def __init__(self, shape: str, support: str, contact: str) -> None:
        self.case = draw(shape, support, contact, "turned", seed=1, loaded=True)
        self.used: set[tuple[str, str]] = set()
        self.told = self._told(package(None, self.used))
        system = equations(self.case)
        placed, state = begin(self.case, system)
        self.expected = instant_of_reference(placed, system, state)
        self.expected["flat at the threshold"] = np.zeros(1)

    def uses(self, change: Change) -> bool:
        """Whether the changed function is called for this body, or is none but a module."""
        name = f"mutant.mechanics.{package_of(change.module)}.{change.module}"
        return not change.function or (name, change.function) in self.used

    def _told(self, changed: Package) -> dict[str, np.ndarray]:
        system = equations(self.case, changed)
        _, state = begin(self.case, system, changed)
        return instant_of_package(system, state) | threshold(system)

    def notices(self, changed: Package) -> bool:
        """Whether this body tells a changed package from the reference."""
        try:
            told = self._told(changed)
            same = told.keys() == self.told.keys()
            return not (same and worst(deviations(told, self.expected)) < 1e-6)
        except FAILURES:
            return True


def threshold(system: System) -> dict[str, np.ndarray]:
    """How much too early or late, relative to it, a body counts as flat; it is at 1e-6."""
    lean = dict(zip(GAMMA, (sp.Rational(3, 5 * 10**6), sp.Rational(4, 5 * 10**6)), strict=False))
    guards = [to_components(guard.value) for guard in system.guards if guard.name == "flat"]
    values = [float(guard.subs(lean) * 10**12) for guard in guards]
    return {"flat at the threshold": np.array(values)} if values else {}


@pytest.fixture(scope="module")
def witnesses():
    return [Witness(*names) for names in BODIES]


def unnoticed(table: dict[str, Change], witnesses: list[Witness]) -> set[str]:
    """Names of the changes that no witness notices."""
    missed = set()
    for name, change in table.items():
        try:
            changed = package(change, set())
        except TypeError:  # an operation that its operands do not have
            continue
        if not any(w.uses(change) and w.notices(changed) for w in witnesses):
            missed.add(name)
    return missed


@pytest.mark.slow
@pytest.mark.parametrize("part", spread(range(PARTS), PARTS))
@pytest.mark.parametrize("module", CHANGED)
def test_every_planted_error_is_noticed(module, part, witnesses):
    every = named(changes(module))
    assert every
    # of a module with fewer changes than parts, the last parts have none
    chosen = dict(list(every.items())[part::PARTS])
    assert unnoticed(chosen, witnesses) == chosen.keys() & HARMLESS.keys()


def test_what_is_harmless_is_a_change():
    assert HARMLESS.keys() <= {name for module in CHANGED for name in named(changes(module))}


@pytest.mark.slow
def test_the_unchanged_package_agrees(witnesses):
    clean = package(None, set())
    assert not any(witness.notices(clean) for witness in witnesses)
