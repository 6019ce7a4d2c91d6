"""What is kept on disk goes by the text of every module that can matter."""

from __future__ import annotations

import ast
import shutil
from pathlib import Path

import pytest

from flowlanes.files.source_digest import (
    PRESENTATION,
    computation_digest,
    module_digests,
    package_digest,
    text_digest,
)
from sources import HOME, files, nodes_of


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The package in a folder of its own."""
    ignored = shutil.ignore_patterns("__pycache__")
    return shutil.copytree(HOME, tmp_path / "package", ignore=ignored)


MODULES = (
    "core/vectors.py",
    "core/laws.py",
    "core/system.py",
    "printing/ordering.py",
    "printing/formula.py",
    "core/parameters.py",
    "proof/level/level_set.py",
    "measures/one_form.py",
    "search/modular_jets.py",
    "mechanics/rolling/equations.py",
    "catalogue/rates.py",
    "explicit/one_degree/uniformisation.py",
    "flow/kernel/runge_kutta.py",
    "flow/machine_code/arithmetic.py",
    "analysis/classification/classes.py",
)


def test_a_change_of_any_module_that_computes_changes_the_digest(copy: Path) -> None:
    assert text_digest(module_digests(copy), PRESENTATION) == computation_digest()
    seen = {computation_digest()}
    for name in MODULES:
        with (copy / name).open("a") as stream:
            stream.write("# mended\n")
        changed = module_digests(copy)
        assert text_digest(changed, PRESENTATION) not in seen, name
        seen.add(text_digest(changed, PRESENTATION))
    assert text_digest(module_digests(copy)) != package_digest()


def test_a_module_that_comes_goes_or_moves_changes_the_digest(copy: Path) -> None:
    seen = {text_digest(module_digests(copy), PRESENTATION)}
    (copy / "proof" / "new.py").write_text("")
    seen.add(text_digest(module_digests(copy), PRESENTATION))
    (copy / "proof" / "new.py").rename(copy / "flow" / "new.py")
    seen.add(text_digest(module_digests(copy), PRESENTATION))
    (copy / "flow" / "new.py").unlink()
    (copy / "flow" / "machine_code" / "jit.py").unlink()
    seen.add(text_digest(module_digests(copy), PRESENTATION))
    assert len(seen) == 4


def test_claims_and_reports_change_only_the_digest_of_the_whole(copy: Path) -> None:
    before = text_digest(module_digests(copy))
    with (copy / "borisov_mamaev" / "section_12" / "section_12.py").open("a") as stream:
        stream.write("# mended\n")
    assert text_digest(module_digests(copy), PRESENTATION) == computation_digest()
    assert text_digest(module_digests(copy)) != before


def imported(path: Path) -> set[str]:
    """The rooms of the package that a module imports, types alone aside."""
    skipped = {
        inner
        for node in nodes_of(path, ast.If)
        if ast.unparse(node.test) == "TYPE_CHECKING"
        for inner in ast.walk(node)
    }
    found = set()
    for node in nodes_of(path, ast.ImportFrom, ast.Import):
        if node in skipped:
            continue
        if isinstance(node, ast.ImportFrom):
            parts = path.relative_to(HOME).parts[:-1]
            base = parts[: len(parts) - node.level + 1] if node.level else ("absolute",)
            place = (*base, *(node.module or "").split("."))
            absolute = (node.module or "").split(".") if not node.level else []
            names = [alias.name for alias in node.names]
            if absolute[:1] == ["chaplygin"]:
                found |= {*absolute[1:2], *names}
            elif node.level:
                found |= {next(filter(None, place), ""), *(names if not any(place) else ())}
        elif isinstance(node, ast.Import):
            found |= {a.name.split(".")[1] for a in node.names if a.name.startswith("chaplygin.")}
    return found


def test_what_computes_imports_nothing_that_is_left_apart() -> None:
    modules = [p for p in files() if p.relative_to(HOME).parts[0] not in PRESENTATION]
    assert len(modules) > 300
    assert imported(HOME / "cli" / "study.py") >= {"report"}
    assert imported(HOME / "report" / "study_output.py") >= {"experiment"}
    wrong = {str(p) for p in modules if imported(p) & set(PRESENTATION)}
    assert wrong == set()


@pytest.mark.parametrize(
    "place", ["proof.verdict_cache", "flow.machine_code.code_cache", "borisov_mamaev.audit"]
)
def test_names_on_disk_hold_the_digest(place: str, monkeypatch: pytest.MonkeyPatch) -> None:
    from borisov_mamaev_2008 import claims
    from borisov_mamaev_2008.audit import _name
    from flowlanes.flow.machine_code import code_cache as cache
    from lawproof.proof.verdict_cache import fingerprint
    from nonholonomic.catalogue import entry

    system = entry("veselova").system()
    name = {
        "proof.verdict_cache": lambda: fingerprint(system, system.laws[0]),
        "flow.machine_code.code_cache": lambda: cache.code_name("formulas"),
        "borisov_mamaev.audit": lambda: _name(claims(12)[0][1], "printed"),
    }[place]
    before = name()
    assert name() == before
    monkeypatch.setattr("flowlanes.files.cache.computation_digest", lambda: "mended")
    other = name()
    assert other != before
    if place == "borisov_mamaev.audit":
        monkeypatch.setattr("borisov_mamaev_2008.audit.package_digest", lambda: "mended")
        assert name() not in (before, other)
