"""Answers that were computed before: the shipped ones, and those in the cache of the user."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from chaplygin.answers import stored
from chaplygin.answers.compute import catalogue_answers
from chaplygin.answers.stored import Answer, Question, keep, shipped_answers
from nonholonomic.catalogue.groups import NAMES

EXAMPLES = Path(__file__).parents[4] / "examples"


def without_times(answers: dict[str, Answer]) -> dict[str, Answer]:
    """The same answers as JSON holds them, without the seconds that proofs took."""
    plain: dict[str, Answer] = {}
    for command, answer in answers.items():
        content = json.loads(json.dumps(answer.content))
        if command.startswith("prove"):
            for verdict in content:
                del verdict["record"]["seconds"]
        plain[command] = Answer(answer.remarks, content)
    return plain


def test_every_system_has_answers() -> None:
    missing = [name for name in NAMES if not shipped_answers(name)]
    assert not missing, f"stale or missing, `make answers` writes them: {', '.join(missing)}"


@pytest.mark.parametrize("name", ["roller-racer", "veselova", "suslov"])
def test_shipped_answers_are_those_computed(name: str) -> None:
    assert without_times(shipped_answers(name)) == without_times(catalogue_answers(name))


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_all_shipped_answers_are_those_computed(name: str) -> None:
    assert without_times(shipped_answers(name)) == without_times(catalogue_answers(name))


def test_an_entry_that_was_changed_has_no_shipped_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stored, "entry_digest", lambda name: "another")
    assert not shipped_answers("veselova")


def test_an_answer_about_a_file_is_kept_until_the_file_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / "cache"))
    file = tmp_path / "coin.toml"
    file.write_text((EXAMPLES / "coin.toml").read_text())
    question = Question("show text", str(file), named=False)
    assert stored.stored(question) is None
    answer = Answer(("a remark",), "equations")
    keep(question, answer)
    assert stored.stored(question) == answer
    assert stored.stored(Question("show text", str(file), False, ("body.mass=2",))) is None
    assert stored.stored(Question("show laws", str(file), named=False)) is None
    file.write_text(file.read_text() + "\n# another file\n")
    assert stored.stored(question) is None


def test_an_answer_about_a_program_is_not_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A program may read anything, so its text does not tell what it makes."""
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / "cache"))
    question = Question("show text", str(tmp_path / "model.py"), named=False)
    keep(question, Answer((), "equations"))
    assert stored.stored(question) is None


@pytest.mark.parametrize("command", ["list", "show", "prove"])
def test_the_catalogue_is_told_without_sympy(command: str) -> None:
    """Heavy libraries are not imported for what is known."""
    what = [] if command == "list" else ["chaplygin-ball"]
    program = (
        "import sys\n"
        f"sys.argv = ['chaplygin', {command!r}, *{what}]\n"
        "from chaplygin.cli import main\n"
        "try:\n    main()\nexcept SystemExit as end:\n    assert not end.code\n"
        "heavy = {'sympy', 'numpy', 'scipy', 'xarray', 'pandas', 'matplotlib', 'llvmlite'}\n"
        "assert not heavy & set(sys.modules), heavy & set(sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", program], check=True, stdout=subprocess.DEVNULL)
