"""Times of whole processes ``chaplygin study`` of catalogue systems, with a cold cache.

Processor time is that of all processes of a study together.  The wall-clock time is smaller if a
second core draws the figures, and larger if other programs use the machine.

Each system is studied in a process of its own with default options and an empty cache, so that
equations, machine code, proofs, figures, the page and the font list of matplotlib are all computed
again; the package is compiled to bytecode first, as in an installation.  With ``--keep`` reports
are kept for comparisons; with ``--results`` the times are stored after each system.
"""

from __future__ import annotations

import argparse
import compileall
import importlib.util
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

UNSET = ("FLOWLANES_CACHE", "MPLCONFIGDIR", "PYTHONDONTWRITEBYTECODE")


def studied(name: str, folder: Path) -> dict[str, float | str]:
    """Processor time (user and system), wall-clock time and memory of one study."""
    with tempfile.TemporaryDirectory() as empty:
        environment = os.environ | {"XDG_CACHE_HOME": empty}
        for variable in UNSET:
            environment.pop(variable, None)
        began = time.perf_counter()
        child = subprocess.Popen(
            [sys.executable, "-m", "chaplygin", "study", name, "-o", str(folder / name)],
            env=environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        _, status, usage = os.wait4(child.pid, 0)
        passed = time.perf_counter() - began
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f"chaplygin study {name} exited with {child.returncode}")
    return {
        "system": name,
        "processor": usage.ru_utime + usage.ru_stime,
        "passed": passed,
        "megabytes": usage.ru_maxrss / 1024,
    }


def _times(row: Mapping[str, Any]) -> str:
    """Line with system, processor time and wall-clock time."""
    return f"{row['system']:36} {row['processor']:6.1f} s {row['passed']:6.1f} s passed"


def main() -> None:
    """Study the given systems, or the whole catalogue."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("systems", nargs="*", help="names; default: the whole catalogue")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("-n", type=int, default=1, help="studies of each system")
    parser.add_argument("--keep", type=Path, help="folder in which reports stay")
    parser.add_argument("--results", type=Path, help="file of results, continued if it is there")
    options = parser.parse_args()
    names = options.systems
    if not names:
        from nonholonomic import CATALOGUE

        names = list(CATALOGUE)
    package = importlib.util.find_spec("chaplygin")
    for folder in package.submodule_search_locations if package else ():
        compileall.compile_dir(folder, quiet=1)
    rows = []
    if options.results and options.results.exists():
        rows = json.loads(options.results.read_text())
    done = {row["system"] for row in rows}
    with tempfile.TemporaryDirectory() as scratch:
        for name in names:
            if name in done:
                continue
            found = []
            for turn in range(options.n):
                folder = options.keep if options.keep and not turn else Path(scratch) / str(turn)
                found.append(studied(name, folder))
            keys = ("processor", "passed", "megabytes")
            medians = {key: statistics.median(f[key] for f in found) for key in keys}
            rows.append({"system": name, **medians})
            if not options.json:
                print(f"{_times(rows[-1])} {medians['megabytes']:5.0f} MB", flush=True)
            if options.results:
                options.results.write_text(json.dumps(rows, indent=2))
    if options.json:
        print(json.dumps(rows, indent=2))
        return
    print("\nlongest:")
    for row in sorted(rows, key=lambda row: -row["processor"])[:12]:
        print(_times(row))


if __name__ == "__main__":
    main()
