"""Objects of every public class: printed, they fit a screen; pickled, they come back.

The instances are those that the example in the docstring of each class makes.
"""

from __future__ import annotations

import doctest
import importlib
import inspect
import math
import pickle
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

import borisov_mamaev_2008
import chaplygin
import flowlanes
import lawproof
import nonholonomic

#: Lines and columns of a screen.
LINES, COLUMNS = 24, 80


def public_classes() -> dict[str, type]:
    """Classes that the packages export, by the name under which they do."""
    found: dict[type, str] = {}
    for home in (flowlanes, lawproof, nonholonomic, borisov_mamaev_2008, chaplygin):
        root = Path(str(home.__file__)).parent
        for path in sorted(root.rglob("__init__.py*")):
            # folders without a stub do not stand in the reference, but for these
            if path.suffix != ".pyi" and path.parent.name not in ("search", "borisov_mamaev_2008"):
                continue
            package = ".".join([home.__name__, *path.parent.relative_to(root).parts])
            module = importlib.import_module(package)
            for name in getattr(module, "__all__", ()):
                value = getattr(module, name)
                if inspect.isclass(value) and value.__module__.startswith(home.__name__):
                    found.setdefault(value, f"{package}.{name}")
    return {
        name: kind
        for kind, name in found.items()
        if not inspect.isabstract(kind) and not issubclass(kind, BaseException)
    }


CLASSES = public_classes()


@cache
def _ball() -> Any:
    return chaplygin.from_catalogue("chaplygin-ball")


def _grid() -> Any:
    axes = [flowlanes.scans.Axis(name, 1.0, 2.0, 3) for name in ("I_1", "I_2")]
    start = {"M": (1, 0, 0), "gamma": (0, 0, 1)}
    return flowlanes.scans.scan_grid(_ball(), *axes, start)


def _event() -> Any:
    disk = chaplygin.from_catalogue("heavy-disk")
    return flowlanes.flow.Event(1.0, disk.guards[0], is_terminal=True)


def _plan() -> Any:
    rotors = tuple(nonholonomic.control.Rotor(axis, 0.1) for axis in ((1, 0, 0), (0, 1, 0)))
    robot = nonholonomic.control.SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, rotors)
    eight = nonholonomic.control.figure_of_eight(0.8, 0.4, 8.0)
    return nonholonomic.control.motion_along(robot, eight, intervals=8, stages=3, iterations=1)


#: Objects of classes whose examples make none.
OTHERS: dict[str, Callable[[], Any]] = {
    "flowlanes.scans.ScanGrid": _grid,
    # made when they are first asked for
    "borisov_mamaev_2008.Claim": lambda: borisov_mamaev_2008.claims(6)[0][1],
    "borisov_mamaev_2008.Finding": lambda: next(
        finding for remark in borisov_mamaev_2008.remarks(12) for finding in remark.findings
    ),
    "borisov_mamaev_2008.Remark": lambda: borisov_mamaev_2008.remarks(6)[0],
    "nonholonomic.catalogue.Entry": lambda: nonholonomic.catalogue.entry("suslov"),
    "nonholonomic.control.MotionPlan": _plan,
    "flowlanes.system.Diagonal": lambda: flowlanes.system.Diagonal("I"),
    "flowlanes.system.Vector": lambda: flowlanes.system.Vector("M"),
    "flowlanes.system.Guard": lambda: chaplygin.from_catalogue("heavy-disk").guards[0],
    "flowlanes.flow.Event": _event,
    # a function of SymPy, which has no __init__
    "flowlanes.Rate": lambda: flowlanes.Rate(sp.Symbol("x", real=True)),
    "flowlanes.flow.Linearisation": lambda: chaplygin.linear_stability(
        _ball(), {"omega": (0, 0, 1), "gamma": (0, 0, 1)}
    ),
}


@cache
def made_by_example(name: str) -> tuple[Any, ...]:
    """The instances of a class that the example in its docstring makes."""
    if name in OTHERS:
        return (OTHERS[name](),)
    kind = CLASSES[name]
    instances: list[Any] = []
    initialise: Callable[..., None] = kind.__init__

    def recorded(self: Any, *arguments: Any, **keywords: Any) -> None:
        initialise(self, *arguments, **keywords)
        instances.append(self)

    examples = doctest.DocTestParser().get_examples(inspect.getdoc(kind) or "")
    names: dict[str, Any] = vars(inspect.getmodule(kind)).copy()
    kind.__init__ = recorded  # type: ignore[misc]
    try:
        for example in examples:
            exec(compile(example.source, name, "single"), names)
    finally:
        kind.__init__ = initialise  # type: ignore[misc]
    exact = [value for value in instances if type(value) is kind]
    return tuple(exact[:3])


def test_the_classes_of_all_packages_are_found() -> None:
    assert len(CLASSES) > 100
    assert {"flowlanes.System", "lawproof.Verdict", "nonholonomic.Body", "chaplygin.Study"} <= {
        *CLASSES
    }
    assert {*OTHERS, *NOT_PICKLED} <= {*CLASSES}


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_a_public_object_fits_a_screen(name: str) -> None:
    instances = made_by_example(name)
    assert instances, "the example in its docstring makes none"
    for value in instances:
        for text in (repr(value), str(value)):
            rows = text.splitlines()
            assert sum(max(1, math.ceil(len(row) / COLUMNS)) for row in rows) <= LINES, text[:2000]
            assert " at 0x" not in text


#: Objects that cannot be pickled; the error says what can.
NOT_PICKLED = {
    "flowlanes.flow.Linearisation": "pickle the eigenvalues",
    "borisov_mamaev_2008.Claim": "pickle the source",
    "borisov_mamaev_2008.Finding": "pickle the source",
    "nonholonomic.closed_form.ClosedForm": "pickle float",
    "nonholonomic.closed_form.NamedConstant": "pickle float",
}


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_a_public_object_can_be_pickled_or_says_how(name: str) -> None:
    for value in made_by_example(name):
        if name in NOT_PICKLED:
            with pytest.raises(TypeError, match=NOT_PICKLED[name]):
                pickle.dumps(value)
        else:
            assert type(pickle.loads(pickle.dumps(value))) is type(value)
