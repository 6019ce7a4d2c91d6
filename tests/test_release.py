"""What is released agrees with itself: the recipe for conda, the citation, the placeholders."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, metadata
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

import pytest
import yaml

from workspace import HOMES, ROOT, tree

#: Metadata of the packages, by the names of the distributions.
PROJECTS: dict[str, dict[str, Any]] = {
    home.parents[1].name: tomllib.loads(
        (home.parents[1] / "pyproject.toml").read_text(encoding="utf-8")
    )
    for home in HOMES.values()
}
LABORATORY = PROJECTS["chaplygin"]
VERSIONS = {
    name: re.findall(
        '^__version__ = "(.*)"$', (home / "_version.py").read_text(encoding="utf-8"), re.M
    )
    for name, home in HOMES.items()
}
STATIC = HOMES["chaplygin"] / "page" / "static"
#: Packages of conda with another name, or a part of them that is enough.
CONDA = {"matplotlib": "matplotlib-base"}
#: The placeholders, and the only files that have them.
PLACEHOLDERS = {
    r"example\.org/chaplygin": sorted(f"packages/{name}/pyproject.toml" for name in PROJECTS),
    r"zenodo\.0000000": ["CITATION.cff"],
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
    wanted = {
        r
        for project in PROJECTS.values()
        for r in project["project"]["dependencies"]
        if r.partition("==")[0] not in PROJECTS
    }
    assert run == [as_in_conda(r) for r in sorted(wanted)]
    assert needs["host"][2:] == [as_in_conda(r) for r in LABORATORY["build-system"]["requires"]]


def test_versions_move_together() -> None:
    """One version of all packages, each of which needs the others in the same one."""
    (version,) = {tuple(found) for found in VERSIONS.values()}
    for project in PROJECTS.values():
        extras = project["project"].get("optional-dependencies", {}).values()
        for requirement in [*project["project"]["dependencies"], *(r for e in extras for r in e)]:
            name, pin, wanted = requirement.partition("==")
            if name.partition("[")[0] in PROJECTS:
                assert (pin, (wanted,)) == ("==", version), requirement


def test_packages_need_what_they_import() -> None:
    """Neither more nor less than the third parties whose names stand in their modules."""
    for name, home in HOMES.items():
        project = PROJECTS[home.parents[1].name]["project"]
        imported = {m for path in home.rglob("*.py") for m in _third_parties(tree(path))}
        extras = project.get("optional-dependencies", {}).values()
        listed = {
            *map(_module, project["dependencies"]),
            *(_module(r) for extra in extras for r in extra),
        }
        found = found_by_name(name)
        assert imported - found <= listed, name
        assert set(map(_module, project["dependencies"])) <= imported | found, name


def _module(requirement: str) -> str:
    """The module that a requirement brings."""
    name = re.split(r"[\[<>=;]", requirement)[0].lower()
    return MODULES.get(name, name.replace("-", "_"))


#: Distributions whose modules have other names.
MODULES = {
    "cuda-bindings": "cuda",
    "cuda-core": "cuda",
    "python-flint": "flint",
}


def found_by_name(package: str) -> set[str]:
    """What a package needs without an import of its own, or has with something else."""
    return {
        # xarray writes NetCDF by these; matplotlib has Pillow, anywidget traitlets
        "chaplygin": {
            "h5netcdf",
            "h5py",
            "borisov_mamaev_2008",
            "PIL",
            "traitlets",
            "mpl_toolkits",
            "pydantic_core",
        },
        # numba and JAX run the code that is written for them
        "flowlanes": {"jax", "numba"},
    }.get(package, set())


def _third_parties(module: ast.Module) -> Iterator[str]:
    """Top-level modules that a file imports, other than those of Python."""
    for node in ast.walk(module):
        names = []
        if isinstance(node, ast.ImportFrom) and not node.level:
            names = [node.module or ""]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        for name in names:
            first = name.split(".")[0]
            if first not in sys.stdlib_module_names and first != "_typeshed":
                yield first


def test_the_recipe_is_of_this_package() -> None:
    recipe, project = read("recipe/recipe.yaml"), LABORATORY["project"]
    assert set(recipe) == {
        *("schema_version", "context", "package", "source", "build", "requirements", "tests"),
        "about",
    }
    assert [recipe["context"]["version"]] == VERSIONS["chaplygin"]
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
    for pattern, places in PLACEHOLDERS.items():
        assert re.search(pattern, said)
        assert sorted(name for name, text in texts.items() if re.search(pattern, text)) == places
        assert all("placeholder" in texts[place].lower() for place in places)


def bundled() -> dict[str, str]:
    """Packages of which the front end has parts, as its build wrote them, with their licences."""
    text = (STATIC / "licences.txt").read_text(encoding="utf-8")
    found = re.findall(
        r"^={80}\n(\S+) [\d.]+\nLicence: (.+)\nSource: https://\S+\n\n(?=\S)", text, re.M
    )
    assert text.count("=" * 80 + "\n") == len(found)
    return dict(found)


def conda_licences() -> list[str]:
    """Files of licences that the package of conda has."""
    files: list[str] = read("recipe/recipe.yaml")["about"]["license_file"]
    return files


def rows(page: str) -> list[list[str]]:
    """The rows of all tables of a page, cell by cell."""
    lines = (ROOT / page).read_text(encoding="utf-8").splitlines()
    return [line.strip("| ").split(" | ") for line in lines if line.startswith("| ")]


def test_the_licence_covers_what_is_bundled() -> None:
    """three.js, uPlot and mediabunny were in the wheel without theirs."""
    licences = bundled()
    # what esbuild names in the bundle itself
    names = re.findall(r"^(\w+)/[\w./-]+\.js:$", (STATIC / "lab.js").read_text("utf-8"), re.M)
    assert set(names) == set(licences) == {"mediabunny", "three", "uplot"}
    project, home = LABORATORY["project"], HOMES["chaplygin"].parents[1]
    assert set(project["license"].split(" AND ")) == {"MIT", *licences.values()}
    assert [(home / name).is_file() for name in project["license-files"]] == [True, True]
    listed = [name.removeprefix("packages/chaplygin/") for name in conda_licences()]
    assert listed == project["license-files"]
    table = {row[0]: row[2] for row in rows("docs/dependencies.md") if len(row) == 3}
    assert {name: table.get(name) for name in licences} == licences


#: Words of metadata, and what they are in the table.
FAMILIES = {"BSD-3-Clause": "BSD", "BSD License": "BSD", "BSD": "BSD", "MIT License": "MIT"}
FAMILIES |= {"Python Software Foundation License": "PSF"}


def licence(name: str) -> str:
    """The licence that an installed package states."""
    known = metadata(name)
    classified = [c for c in known.get_all("Classifier") or () if c.startswith("License ::")]
    stated = known.get("License-Expression") or (
        classified[0].split(" :: ")[-1] if classified else known.get("License")
    )
    return FAMILIES.get(stated, stated)


def test_licences_of_dependencies_are_those_that_they_state() -> None:
    needs = [
        requirement
        for project in PROJECTS.values()
        for listed in (
            project["project"]["dependencies"],
            *project["project"].get("optional-dependencies", {}).values(),
        )
        for requirement in listed
    ]
    names = {re.match(r"[\w-]+", requirement).group() for requirement in needs}  # type: ignore[union-attr]
    names -= PROJECTS.keys()
    listed = {
        word: row[0]
        for row in rows("docs/dependencies.md")
        if re.match(r"(MIT|BSD|Apache|PSF|MPL)", row[0])
        for word in re.findall(r"[\w-]+", row[1].partition(", which")[0])
    }
    assert set(listed) == names
    installed = {name for name in names if is_installed(name)}
    assert len(installed) > 20
    assert {name: licence(name) for name in installed} == {n: listed[n] for n in installed}


def is_installed(name: str) -> bool:
    """Whether there is a package of this name."""
    try:
        metadata(name)
    except PackageNotFoundError:
        return False
    return True


def test_platforms_are_those_that_the_resolver_was_asked_for() -> None:
    """Classifiers promised systems without wheels."""
    spec = spec_from_file_location("platforms", ROOT / "scripts" / "platforms.py")
    assert spec is not None and spec.loader is not None
    script = module_from_spec(spec)
    spec.loader.exec_module(script)
    table = {row[0]: row[1:] for row in rows("docs/dependencies.md") if len(row) == 5}
    assert set(table) >= set(script.PLATFORMS.values())
    answers = [table[name] for name in script.PLATFORMS.values()]
    assert all(re.match("yes|no: ", answer) for row in answers for answer in row)
    assert {len(row) for row in answers} == {len(script.PYTHONS)}
    (classifiers,) = {tuple(p["project"]["classifiers"]) for p in PROJECTS.values()}
    # a classifier is for a system on all of its processors; musl is Linux too, as the page says
    assert [c for c in classifiers if c.startswith("Operating")] == [
        "Operating System :: POSIX :: Linux"
    ]
    versions = [c.rpartition(" ")[2] for c in classifiers if re.search(r"Python :: 3\.", c)]
    assert versions == list(script.PYTHONS)
