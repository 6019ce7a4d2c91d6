"""Files of the packages whose functions are entered on a walk, as docs/architecture.md counts them.

    python scripts/files_entered.py file|prove|solve|ensemble|study [--list]

What runs while a module is imported is not counted.  The report of `study` is written to a folder
of its own that is removed; a verdict that is cached takes fewer files: point FLOWLANES_CACHE at an
empty one.
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from contextlib import nullcontext
from pathlib import Path
from types import FrameType
from unittest.mock import patch

import chaplygin as ch
import nonholonomic
from chaplygin.cli import main

PACKAGES = Path(__file__).parents[1] / "packages"
EXAMPLE = PACKAGES.parent / "examples" / "rattleback.toml"


def files_entered(walk: Callable[[], object]) -> list[str]:
    """The files with functions that a walk enters, in the order of the first entry."""
    home = f"{PACKAGES}/"
    files: dict[str, None] = {}

    def note(frame: FrameType, event: str, _: object) -> None:
        file = frame.f_code.co_filename
        if event != "call" or file in files or not (file.startswith(home) and file.endswith(".py")):
            return
        caller: FrameType | None = frame
        while caller is not None:
            if caller.f_code.co_name == "<module>" and caller.f_code.co_filename.startswith(home):
                return
            caller = caller.f_back
        files[file] = None

    sys.setprofile(note)
    try:
        walk()
    finally:
        sys.setprofile(None)
    return [file.split("/src/")[1] for file in files]


def write_report(folder: str) -> None:
    """Run ``chaplygin study``, with the figures drawn in this process instead of a copy."""
    sys.argv = ["chaplygin", "study", str(EXAMPLE), "-o", f"{folder}/report"]
    try:
        with patch("chaplygin.report.study_output.beside", nullcontext):
            main()
    except SystemExit as end:
        if end.code:
            raise


def walk_of(name: str, folder: str) -> Callable[[], object]:
    """A walk by its name, with all that comes before it done."""
    entry = nonholonomic.CATALOGUE["veselova"]
    veselova, start = entry.system(), entry.start.values
    state = ch.initial_state(veselova, **start)[: len(veselova.symbols)]
    walks: dict[str, Callable[[], object]] = {
        "file": lambda: ch.Study.from_experiment(ch.load_experiment(EXAMPLE)),
        "prove": lambda: ch.prove(veselova, veselova.integrals[0]),
        "solve": lambda: ch.solve(veselova, start),
        "ensemble": lambda: ch.ensemble(veselova, [state] * 50, [0.0, 1.0]),
        "study": lambda: write_report(folder),
    }
    return walks[name]


if __name__ == "__main__":
    name, *listed = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        entered = files_entered(walk_of(name, folder))
    counts = Counter(file.split("/")[0] for file in entered)
    parts = ", ".join(f"{count} of {package}" for package, count in counts.most_common())
    print(f"{name}: {len(entered)} files ({parts})")
    if listed:
        print("\n".join(entered))
