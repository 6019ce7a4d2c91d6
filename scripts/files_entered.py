"""Files of the package whose functions are entered on a walk, as docs/architecture.md counts them.

    python scripts/files_entered.py study|report|verdict|solution [--list]

What runs while a module is imported is not counted.  The report is written to a folder of its own
that is removed; a verdict that is cached takes fewer files: point FLOWLANES_CACHE at an empty one.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable
from contextlib import nullcontext
from pathlib import Path
from types import FrameType
from unittest.mock import patch

import chaplygin as ch
import nonholonomic
from chaplygin.cli import main

HOME = str(Path(ch.__file__).parent)
EXAMPLE = Path(__file__).parents[1] / "examples" / "rattleback.toml"


def files_entered(walk: Callable[[], object]) -> list[str]:
    """Paths below the package, in order, of the files with functions that a walk enters."""
    files: set[str] = set()

    def note(frame: FrameType, event: str, _: object) -> None:
        file = frame.f_code.co_filename
        if event != "call" or file in files or not (file.startswith(HOME) and file.endswith(".py")):
            return
        caller: FrameType | None = frame
        while caller is not None:
            if caller.f_code.co_name == "<module>" and caller.f_code.co_filename.startswith(HOME):
                return
            caller = caller.f_back
        files.add(file)

    sys.setprofile(note)
    try:
        walk()
    finally:
        sys.setprofile(None)
    return sorted(file[len(HOME) + 1 :] for file in files)


def write_report(folder: str) -> None:
    """The command ``chaplygin study``, with the figures drawn in this process, not in a copy."""
    sys.argv = ["chaplygin", "study", str(EXAMPLE), "-o", f"{folder}/report"]
    try:
        with patch("chaplygin.report.study_output.beside", nullcontext):
            main()
    except SystemExit as end:
        if end.code:
            raise


def walk_of(name: str, folder: str) -> Callable[[], object]:
    """A walk by its name, with all that comes before it done."""
    veselova = ch.from_catalogue("veselova")
    walks: dict[str, Callable[[], object]] = {
        "study": lambda: ch.Study.from_experiment(ch.load_experiment(EXAMPLE)),
        "report": lambda: write_report(folder),
        "verdict": lambda: ch.prove(veselova, veselova.integrals[0]),
        "solution": lambda: ch.solve(veselova, nonholonomic.CATALOGUE["veselova"].start.values),
    }
    return walks[name]


if __name__ == "__main__":
    name, *listed = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        entered = files_entered(walk_of(name, folder))
    print(f"{name}: {len(entered)} files")
    if listed:
        print("\n".join(entered))
