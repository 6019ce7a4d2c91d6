"""The docstring of every public name has an example that runs, and tells what comes back."""

from __future__ import annotations

import doctest
import inspect
import re
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

import chaplygin
import chaplygin.experiment
import chaplygin.report
import chaplygin.server
import flowlanes
import lawproof
import nonholonomic
import nonholonomic.catalogue
from workspace import HOMES, ORDER, modules

#: The public names of the packages.
PUBLIC = {
    name: getattr(package, name)
    for package in (flowlanes, lawproof, nonholonomic, chaplygin)
    for name in package.__all__
    if name != "__version__" and not inspect.ismodule(getattr(package, name))
}
NAMES = sorted(PUBLIC)
FUNCTIONS = [name for name in NAMES if inspect.isroutine(inspect.unwrap(PUBLIC[name]))]
#: An example begins with the import of a package.
STARTS = {f"import {name}\n" for name in (*ORDER, "chaplygin as ch", "sympy as sp")}
OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


def documented(name: str) -> Any:
    """What has the docstring of a name: a class or a function, not what checks its arguments.

    The dictionary of the catalogue has none of its own; its folder stands for it.
    """
    thing = PUBLIC[name]
    if callable(thing):
        return inspect.unwrap(thing)
    return nonholonomic.catalogue


def sections(name: str) -> set[str]:
    """The headings of a docstring."""
    return set(re.findall(r"^(\w[\w ]*)\n-+$", inspect.getdoc(documented(name)) or "", re.M))


#: Examples that take seconds.
SLOW = {
    "audit",
    "nonholonomic.contact.invariants.free_contact",
    "nonholonomic.control.planner",
    "nonholonomic.closed_form.rigorous",
    "chaplygin.report.study_output",
}


def parted(names: list[str]) -> list[Any]:
    """The names, with those of long examples among the slow tests."""
    return [pytest.param(n, marks=pytest.mark.slow if n in SLOW else ()) for n in names]


@pytest.mark.parametrize("name", parted(NAMES))
def test_the_example_gives_what_it_shows(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (found,) = doctest.DocTestFinder(recurse=False).find(documented(name), name, globs={})
    assert found.examples, f"the docstring of {name} has no example"
    assert found.examples[0].source in STARTS
    assert any(example.want for example in found.examples), "an example shows a result"
    assert not any(example.options.get(doctest.SKIP) for example in found.examples)
    report: list[str] = []
    failed, _ = doctest.DocTestRunner(optionflags=OPTIONS).run(found, out=report.append)
    assert not failed, "".join(report)
    assert list(tmp_path.iterdir()) == [], "an example leaves files only in a temporary folder"


def test_a_wrong_result_is_reported() -> None:
    found = doctest.DocTestParser().get_doctest(">>> 1 + 1\n3\n", {}, "sum", None, 0)
    report: list[str] = []
    failed, _ = doctest.DocTestRunner(optionflags=OPTIONS).run(found, out=report.append)
    assert failed == 1 and "Got:\n    2" in "".join(report)


def test_examples_stand_below_their_heading() -> None:
    heading = re.compile(r"^Examples\n--------\n>>> import \w+( as \w+)?$", re.M)
    assert [n for n in NAMES if not heading.search(inspect.getdoc(documented(n)) or "")] == []


def missing_sections(name: str) -> set[str]:
    """The headings that the docstring of a public function lacks."""
    signature = inspect.signature(documented(name))
    needed = {"Raises"} | ({"Parameters"} if signature.parameters else set())
    if signature.return_annotation not in (None, "None"):
        needed.add("Returns")
    return needed - sections(name)


def test_functions_tell_what_they_take_return_and_refuse() -> None:
    assert {name: lost for name in FUNCTIONS if (lost := missing_sections(name))} == {}


def test_functions_are_found_below_what_checks_their_arguments() -> None:
    assert {"rolling_system", "batch_integrator", "prove"} <= set(FUNCTIONS)
    assert not {"System", "CATALOGUE"} & set(FUNCTIONS)


def names_below(package: Any, seen: set[str]) -> dict[str, Any]:
    """Everything that the namespaces below a package offer, by its dotted name."""
    offered: dict[str, Any] = {}
    for name in package.__all__:
        value = getattr(package, name)
        if not inspect.ismodule(value):
            offered[f"{package.__name__}.{name}"] = value
        elif value.__name__ not in seen and hasattr(value, "__all__"):
            seen.add(value.__name__)
            offered |= names_below(value, seen)
    return offered


OFFERED = {
    name: inspect.unwrap(value)
    for name, value in {
        **names_below(flowlanes, {"flowlanes", "flowlanes.formulas", "flowlanes.parsing"}),
        **names_below(lawproof, {"lawproof"}),
        **names_below(nonholonomic, {"nonholonomic"}),
        **names_below(chaplygin, {"chaplygin"}),
        **names_below(chaplygin.experiment, {"chaplygin.experiment"}),
        **names_below(chaplygin.report, {"chaplygin.report"}),
        **names_below(chaplygin.server, {"chaplygin.server"}),
    }.items()
    if callable(value)
}
#: What takes too long, or too many other things, for an example of a few lines.
WITHOUT_EXAMPLE = {
    "nonholonomic.control.MotionPlan",
    "chaplygin.report.figures.ball_figures",
    "chaplygin.report.figures.ball_scene",
    "chaplygin.report.figures.plan_view",
    "chaplygin.report.figures.revolution_diagram",
    "chaplygin.report.figures.scene",
}


def has_example(value: Any) -> bool:
    """Whether a name stands in an example: of its own docstring, or of another in its module."""
    lines = re.findall(
        r"^ *(?:>>>|\.\.\.) (.*)$", inspect.getsource(inspect.getmodule(value)), re.M
    )
    return ">>>" in (inspect.getdoc(value) or "") or any(
        re.search(rf"\b{value.__name__}\b", line) for line in lines
    )


def test_every_name_of_a_namespace_has_an_example() -> None:
    assert len(OFFERED) > 250
    without = {name for name, value in OFFERED.items() if not has_example(value)}
    assert without == WITHOUT_EXAMPLE
    assert not has_example(flowlanes.system.vector_operators.outer)


def undocumented(function: Any) -> list[str]:
    """Headings that the docstring of a function lacks, and arguments it lacks or has too many."""
    text, signature = inspect.getdoc(function) or "", inspect.signature(function)
    found = dict(re.findall(r"^(\w[\w ]*)\n-+\n(.*?)(?=\n\n\w[\w ]*\n-+\n|\Z)", text, re.M | re.S))
    needed = ["Raises"]
    if signature.return_annotation not in (None, "None"):
        needed.append("Returns")
    described = re.findall(r"^(\S.*?)(?: :.*)?$", found.get("Parameters", ""), re.M)
    # a function without arguments has no such section
    names = {part.strip().lstrip("*") for line in described for part in line.split(",")}
    return [n for n in needed if n not in found] + sorted(names ^ set(signature.parameters))


def test_functions_of_namespaces_document_their_own_arguments() -> None:
    functions = {name: value for name, value in OFFERED.items() if inspect.isroutine(value)}
    assert len(functions) > 100
    assert {name: lost for name, f in functions.items() if (lost := undocumented(f))} == {}


#: Modules with examples of names that are not public.
MODULES = sorted(
    name for name, path in modules(HOMES).items() if ">>>" in path.read_text(encoding="utf-8")
)


@pytest.mark.parametrize("name", parted(MODULES))
def test_examples_of_a_module_run(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    module = import_module(name)
    public = {id(documented(name)) for name in NAMES}
    runner = doctest.DocTestRunner(optionflags=OPTIONS)
    report: list[str] = []
    for found in doctest.DocTestFinder(exclude_empty=True).find(module):
        inner = found.name.removeprefix(f"{name}.")
        if id(inspect.unwrap(getattr(module, inner, module))) not in public:
            runner.run(found, out=report.append)
    assert not runner.failures, "".join(report)
