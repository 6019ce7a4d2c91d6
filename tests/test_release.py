"""What is released agrees with itself: the recipe for conda, the citation, the placeholders."""

from __future__ import annotations

import re
import subprocess
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

import chaplygin

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
#: Packages of conda with another name, or a part of them that is enough.
CONDA = {"matplotlib": "matplotlib-base"}
#: The placeholders, and the only files that have them.
PLACEHOLDERS = {
    r"example\.org/chaplygin": "pyproject.toml",
    r"zenodo\.0000000": "CITATION.cff",
}


def read(place: str) -> Any:
    return yaml.safe_load((ROOT / place).read_text(encoding="utf-8"))


def as_in_conda(requirement: str) -> str:
    """A requirement of Python's packages as conda writes it."""
    name, version = re.fullmatch(r"([\w-]+)(.*)", requirement).groups()  # type: ignore[union-attr]
    return f"{CONDA.get(name, name)} {version}".strip()


def test_the_recipe_needs_what_the_package_needs() -> None:
    needs = read("recipe/recipe.yaml")["requirements"]
    python, *run = needs["run"]
    assert python == "python >=${{ python_min }}"
    assert run == [as_in_conda(r) for r in PROJECT["project"]["dependencies"]]
    assert needs["host"][2:] == [as_in_conda(r) for r in PROJECT["build-system"]["requires"]]


def test_the_recipe_is_of_this_package() -> None:
    recipe, project = read("recipe/recipe.yaml"), PROJECT["project"]
    assert set(recipe) == {
        *("schema_version", "context", "package", "source", "build", "requirements", "tests"),
        "about",
    }
    assert recipe["context"]["version"] == chaplygin.__version__
    assert project["requires-python"] == f">={recipe['context']['python_min']}"
    assert recipe["package"] == {"name": project["name"], "version": "${{ version }}"}
    (script,) = project["scripts"].items()
    assert recipe["build"]["python"]["entry_points"] == [" = ".join(script)]
    assert recipe["about"]["summary"] == project["description"]
    assert recipe["about"]["license"] == project["license"]


def test_placeholders_are_where_they_are_said_to_be() -> None:
    said = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False
    ).stdout.split("\n")
    files = [ROOT / name for name in listed if name] or pytest.skip("this is no repository")
    here = Path(__file__)
    texts = {
        f.relative_to(ROOT).as_posix(): f.read_text(encoding="utf-8", errors="ignore")
        for f in files
        if f.is_file() and f not in (here, ROOT / "CONTRIBUTING.md") and f.suffix != ".js"
    }
    for pattern, place in PLACEHOLDERS.items():
        assert re.search(pattern, said)
        assert [name for name, text in texts.items() if re.search(pattern, text)] == [place]
    assert "placeholder" in texts["CITATION.cff"].lower()
    assert "placeholder" in texts["pyproject.toml"].lower()
