"""The files of the catalogue: found without SymPy, valid experiment files, one for each system."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from chaplygin.experiment.catalogue_text import catalogue_text, same_equations
from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from nonholonomic.catalogue import CATALOGUE, file_systems
from nonholonomic.catalogue.entry_files import entry_file, entry_files, read_head
from nonholonomic.catalogue.file_systems import claimed_system
from nonholonomic.catalogue.groups import GROUPS
from studies import catalogue_study

#: Systems of each kind of file: equations, a Lagrangian, conditional laws, a body, a mechanism of
#: a family.
EXAMPLES = ("lagrange-top", "snakeboard", "two-veselova-constraints", "heavy-disk", "suslov-nd")


def test_the_names_and_titles_need_no_sympy() -> None:
    code = (
        "import sys; import nonholonomic; assert nonholonomic.CATALOGUE.titles['veselova']; "
        "from chaplygin.cli.list_ import command; command(None, '6', False, False); "
        "print({'sympy', 'numpy', 'pydantic'} & set(sys.modules))"
    )
    made = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    assert "Veselova system" in made.stdout
    assert made.stdout.endswith("set()\n")


def test_every_file_has_a_group_of_the_catalogue() -> None:
    keys = {group.key for group in GROUPS}
    assert [file.name for file in entry_files() if file.group not in keys] == []


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_entry_is_that_of_its_file(name: str) -> None:
    file, item = entry_file(name), CATALOGUE[name]
    assert (item.title, item.source) == (file.title, file.source)
    if item.family is None:
        assert dict(item.defaults) == file.parameters
        assert item.start.values == file.start


def reads_back(name: str) -> str:
    """What `show NAME --as toml` prints, or why it cannot; it reads back to the same system."""
    study = catalogue_study(name)
    try:
        text = catalogue_text(study)
    except InputError as error:
        return str(error)
    again = Study.from_experiment(parse_experiment(text))
    assert same_equations(again.system, study.system)
    # the start of a ball is written as the state that follows from its place
    assert list(map(float, again.start)) == pytest.approx(list(map(float, study.start)), rel=1e-14)
    assert again.until == study.until
    # what a file of the motion has as its experiment
    kept = Study.from_experiment(parse_experiment(again.complete_toml())).system
    assert replace(kept, laws=()) == replace(again.system, laws=())
    assert {law.name for law in kept.laws} == {law.name for law in again.system.laws}
    return ""


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_file_brings_the_same_system(name: str) -> None:
    said = reads_back(name)
    assert bool(said) == (name == "suslov-nd")
    if said:
        assert said.startswith(
            "--as toml: suslov-nd cannot be written as a file of equations, since"
        )


@pytest.mark.slow
def test_every_file_brings_the_same_system() -> None:
    said = {name: words for name in CATALOGUE if (words := reads_back(name))}
    assert not any(entry_file(name).complete for name in said)
    families = {name for name, item in CATALOGUE.items() if item.family is not None}
    assert families <= said.keys()
    assert all(words.count("\n") == 0 for words in said.values())


#: A ball starts at its centre, although the surface that carries it is given.
BY_CENTRE = {
    "marble-ball-on-cylinder",
    "marble-ball-on-sphere",
    "marble-ball-on-torus",
    "rubber-ball-on-torus",
}


def test_the_file_of_a_body_is_an_experiment_with_that_body() -> None:
    files = [f for f in entry_files() if "body" in f.tables and f.name not in BY_CENTRE]
    assert len(files) > 20
    for file in files:
        made = Study.from_experiment(parse_experiment(file.text))
        item = CATALOGUE[file.name]
        system = item.system()
        assert made.subject.until == item.start.until
        assert (made.system.field, made.system.definitions) == (system.field, system.definitions)
        assert made.system.default_values == system.default_values
        assert made.system.observables == system.observables
        assert {law.name for law in system.integrals} <= {law.name for law in made.system.integrals}


def test_parameters_change_numbers_and_the_laws_that_hold_for_them() -> None:
    free, driven = (
        CATALOGUE["two-veselova-constraints"].system({"K": strength}) for strength in (0.0, 1.0)
    )
    assert {law.name for law in free.laws} - {law.name for law in driven.laws} == {"momentum"}
    assert CATALOGUE["veselova"].system({"I_1": 1.2}).default_values[0] == ("I_1", 1.2)


@pytest.mark.parametrize(
    ("name", "numbers", "said"),
    [
        ("lagrange-top", {"I_1": -1.0}, "I_1 = -1.0, I_3 = 0.6: I_3 <= 2*I_1 must hold"),
        (
            "veselova",
            {"I_3": 9.0},
            "moment of inertia about body axis 3 I_3 = 9.0 is not admissible; "
            "I_3 <= I_1 + I_2 must hold",
        ),
        (
            "veselova",
            {"I_3": float("nan")},
            "moment of inertia about body axis 3 I_3 = nan must be a finite number",
        ),
        ("snakeboard", {"m": 0.0}, "mass m = 0.0 is not admissible; m > 0 must hold"),
    ],
)
def test_numbers_that_are_not_admissible(name: str, numbers: dict[str, float], said: str) -> None:
    with pytest.raises(InputError, match="must") as caught:
        CATALOGUE[name].system(numbers)
    assert str(caught.value) == f"{name}: {said}"


def test_laws_of_other_numbers_are_those_of_the_general_system() -> None:
    general = CATALOGUE["veselova-gyrostat-bruns"].general
    assert general is not None
    assert [law.name for law in general().laws] == ["momentum", "momentum_in_field"]
    assert {
        law.name for law, where in claimed_system("veselova-gyrostat-bruns").claims if where
    } == {
        "momentum",
        "momentum_in_field",
    }


def test_a_file_without_its_place_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "odd.toml"
    path.write_text('title = "Odd"\n\n[parameters]\nk = 1.0\n')
    with pytest.raises(InputError, match=r"odd.toml: title and catalogue.group must stand before"):
        read_head(path)


def test_a_file_under_another_name_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    right = entry_file("suslov-bracket")
    odd = replace(right, name="odd")
    monkeypatch.setattr(file_systems, "entry_file", lambda name: odd)
    with pytest.raises(InputError, match=r'line 2, name: must be "odd", as the file is called'):
        file_systems.claimed_system("odd")
