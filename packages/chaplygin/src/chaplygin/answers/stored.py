"""Answers that were computed before, so that a command need not derive and prove again.

Two places hold them.  For each system of the catalogue with its own parameters a file beside this
module comes with the package; ``make answers`` writes it, and tests compare what it says with what
is computed.  It counts as long as the entry of the catalogue is the one from which it was computed.
All other answers are kept in the cache of the user, under a digest of everything they depend on:
the file or entry, the overrides, the program text and the versions of the libraries.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nonholonomic.catalogue.entry_files import FOLDER as CATALOGUE_FOLDER, entry_file, paths

SHIPPED = Path(__file__).parent / "catalogue"
"""The folder of the files that come with the package."""


@dataclass(frozen=True)
class Question:
    """A command about a system.

    Attributes
    ----------
    command : str
        Such as ``"show text"``.
    what : str
        The name in the catalogue, or the path of the experiment file.
    named : bool
        Whether it is a name.
    overrides : tuple of str
        Keys of the file that are replaced, as ``"body.mass=2"``.
    """

    command: str
    what: str
    named: bool
    overrides: tuple[str, ...] = ()


@dataclass(frozen=True)
class Answer:
    """What a command prints.

    Attributes
    ----------
    remarks : tuple of str
        Corrections of the input, said before the answer.
    content : str, list or dict
        A text, or what JSON can hold.
    """

    remarks: tuple[str, ...]
    content: Any


def stored(question: Question) -> Answer | None:
    """The stored answer to a question, if there is one."""
    if (answer := _shipped(question)) is not None:
        return answer
    from flowlanes.files import private_files

    place = _place(question)
    text = None if place is None else private_files.read_private(place)
    return None if text is None else _answer(json.loads(text))


def keep(question: Question, answer: Answer) -> None:
    """Store an answer in the cache of the user; if the disk does not allow it, it is lost."""
    from flowlanes.files import private_files

    place = _place(question)
    if place is not None:
        private_files.write_private(place, json.dumps(_as_json(answer)).encode())


def write_shipped(name: str, answers: dict[str, Answer]) -> None:
    """Write the answers of a system of the catalogue, by command, into the package."""
    SHIPPED.mkdir(exist_ok=True)
    content = {
        "entry": entry_digest(name),
        **{command: _as_json(answer) for command, answer in sorted(answers.items())},
    }
    text = json.dumps(content, ensure_ascii=False, indent=1)
    (SHIPPED / f"{name}.json").write_text(text + "\n", encoding="utf-8")


def shipped_answers(name: str) -> dict[str, Answer]:
    """The answers that come with the package for a system, by command; none if they are stale."""
    path = SHIPPED / f"{name}.json"
    if name not in paths() or not path.is_file():
        return {}
    content = json.loads(path.read_text(encoding="utf-8"))
    if content.pop("entry") != entry_digest(name):
        return {}
    return {command: _answer(answer) for command, answer in content.items()}


def entry_digest(name: str) -> str:
    """A digest of the entry of the catalogue: its file, and the module that makes its equations."""
    file = entry_file(name)
    module = CATALOGUE_FOLDER.joinpath(*file.python.split(".")).with_suffix(".py")
    texts = [file.text, *([module.read_text(encoding="utf-8")] if file.python else [])]
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()


def _shipped(question: Question) -> Answer | None:
    if not question.named or question.overrides:
        return None
    return shipped_answers(question.what).get(question.command)


def _place(question: Question) -> Path | None:
    """The file in the cache for an answer; None for what can change without its own text."""
    from flowlanes.files.cache import entry_name, folder
    from flowlanes.files.source_digest import package_digest

    if question.named:
        # entries made by a program have no file
        if question.what not in paths():
            return None
        text = entry_file(question.what).text
    elif question.what.endswith(".py"):
        # a program may read anything
        return None
    else:
        text = Path(question.what).read_text(encoding="utf-8", errors="surrogateescape")
    parts = (question.command, question.what, text, package_digest("chaplygin"))
    name = entry_name("answer", *map(_escaped, (*parts, *question.overrides)))
    return folder() / f"{name}.json"


def _escaped(text: str) -> str:
    return text.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")


def _as_json(answer: Answer) -> dict[str, Any]:
    return {"remarks": list(answer.remarks), "content": answer.content}


def _answer(stored_answer: dict[str, Any]) -> Answer:
    return Answer(tuple(stored_answer["remarks"]), stored_answer["content"])
