"""What is kept on disk goes by the text of every module that can matter."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from flowlanes.files.source_digest import (
    computation_digest,
    module_digests,
    package_digest,
    programs,
    text_digest,
)


def digests(folder: Path) -> dict[str, str]:
    """Digests of the modules of all packages that lie in a folder."""
    homes = sorted(path for path in folder.iterdir() if path.is_dir())
    return {name: value for home in homes for name, value in module_digests(home).items()}


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The packages that compute, side by side in a folder of their own."""
    ignored = shutil.ignore_patterns("__pycache__")
    for home in programs():
        shutil.copytree(home, tmp_path / home.name, ignore=ignored)
    return tmp_path


def test_every_package_that_computes_counts() -> None:
    names = [home.name for home in programs()]
    assert names == ["certificate_checker", "flowlanes", "lawproof", "nonholonomic"]


MODULES = (
    "flowlanes/system/vectors.py",
    "flowlanes/system/laws.py",
    "flowlanes/system/system.py",
    "flowlanes/printing/ordering.py",
    "flowlanes/printing/formula.py",
    "flowlanes/system/parameters.py",
    "lawproof/proof/level/level_set.py",
    "nonholonomic/invariant_measures/one_form.py",
    "lawproof/search/modular_jets.py",
    "nonholonomic/mechanics/rolling/equations.py",
    "nonholonomic/closed_form/one_degree/uniformisation.py",
    "flowlanes/flow/kernel/runge_kutta.py",
    "flowlanes/flow/machine_code/arithmetic.py",
    "nonholonomic/classification/classes.py",
    "certificate_checker/certificate.py",
)


def test_a_change_of_any_module_that_computes_changes_the_digest(copy: Path) -> None:
    assert text_digest(digests(copy)) == computation_digest()
    seen = {computation_digest()}
    for name in MODULES:
        with (copy / name).open("a") as stream:
            stream.write("# mended\n")
        changed = text_digest(digests(copy))
        assert changed not in seen, name
        seen.add(changed)


def test_a_module_that_comes_goes_or_moves_changes_the_digest(copy: Path) -> None:
    seen = {text_digest(digests(copy))}
    (copy / "lawproof" / "proof" / "new.py").write_text("")
    seen.add(text_digest(digests(copy)))
    (copy / "lawproof" / "proof" / "new.py").rename(copy / "flowlanes" / "flow" / "new.py")
    seen.add(text_digest(digests(copy)))
    (copy / "flowlanes" / "flow" / "new.py").unlink()
    (copy / "flowlanes" / "flow" / "machine_code" / "jit.py").unlink()
    seen.add(text_digest(digests(copy)))
    assert len(seen) == 4


def test_claims_and_reports_have_digests_of_their_own() -> None:
    packages = ("flowlanes", "borisov_mamaev_2008", "chaplygin", "no_such_package")
    assert len({*map(package_digest, packages), computation_digest()}) == 5


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
        monkeypatch.setattr("borisov_mamaev_2008.audit.package_digest", lambda name: "mended")
        assert name() not in (before, other)
