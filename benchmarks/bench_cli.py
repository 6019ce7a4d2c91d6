"""The command line from outside: seconds of whole processes, beside ``import sympy``.

Cold runs have an empty cache and a home of their own.  The processes of one round follow each
other, so that all of them meet the same machine; the ratios are to the import of SymPy in the same
round.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

COMMAND = str(Path(sys.executable).with_name("chaplygin"))
EXAMPLES = Path(__file__).parents[1] / "examples"
REFERENCE = "python -c 'import sympy'"

#: What a user types; FOLDER stands for a place to write to.
COMMANDS = {
    REFERENCE: [sys.executable, "-c", "import sympy"],
    "from_catalogue": [
        sys.executable,
        "-c",
        "import chaplygin as ch; ch.from_catalogue('chaplygin-ball')",
    ],
    "list": [COMMAND, "list"],
    "show chaplygin-ball": [COMMAND, "show", "chaplygin-ball"],
    "show coin.toml": [COMMAND, "show", str(EXAMPLES / "coin.toml")],
    "prove chaplygin-ball": [COMMAND, "prove", "chaplygin-ball"],
    "prove coin.toml": [COMMAND, "prove", str(EXAMPLES / "coin.toml")],
    "run unbalanced-ball -o b.csv": [
        *(COMMAND, "run", "unbalanced-ball", "-o", "FOLDER/b.csv", "--force"),
    ],
    "solve veselova --at 0,1,1e6": [COMMAND, "solve", "veselova", "--at", "0,1,1e6"],
    "section unbalanced-ball, 12 × 300 points": [
        *(COMMAND, "section", "unbalanced-ball", "--on", "gamma_3", "--starts", "12"),
        *("--points", "300", "-o", "FOLDER/s.zarr", "--force"),
    ],
    "study rattleback": [COMMAND, "study", "rattleback", "-o", "FOLDER/r", "--force"],
    "study rattleback --quick": [
        *(COMMAND, "study", "rattleback", "-o", "FOLDER/q", "--force", "--quick"),
    ],
    "study chaplygin-ball": [COMMAND, "study", "chaplygin-ball", "-o", "FOLDER/c", "--force"],
}


@dataclass(frozen=True)
class Run:
    """A process that has ended: seconds on the clock and of the processors."""

    seconds: float
    processor: float


def process(arguments: list[str], home: Path) -> Run:
    """Run a process with this home, where its caches are."""
    environment = os.environ | {
        "HOME": str(home),
        "XDG_CACHE_HOME": str(home / "cache"),
        "FLOWLANES_CACHE": str(home / "cache" / "flowlanes"),
        "MPLCONFIGDIR": str(home / "matplotlib"),
    }
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    began = time.perf_counter()
    ended = subprocess.run(
        [argument.replace("FOLDER", str(home)) for argument in arguments],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    seconds = time.perf_counter() - began
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    # `prove` says by its status whether all is proven.
    if ended.returncode not in (0, 1) or "Traceback" in ended.stderr:
        raise SystemExit(f"{' '.join(arguments)} exited with {ended.returncode}\n{ended.stderr}")
    return Run(seconds, sum(after[:2]) - sum(before[:2]))


def rounds(names: list[str], count: int, cold: bool) -> Iterator[dict[str, Run]]:
    """The runs of each round, by command."""
    with tempfile.TemporaryDirectory() as name:
        home = Path(name)
        if not cold:
            for command in names:
                process(COMMANDS[command], home)
        for number in range(count):
            own = home / str(number) if cold else home
            own.mkdir(exist_ok=True)
            yield {command: process(COMMANDS[command], own) for command in names}


def rows(names: list[str], count: int, cold: bool) -> list[dict[str, str | float]]:
    """Medians of the seconds of each command, and of their ratios to the import of SymPy."""
    done = list(rounds(names, count, cold))
    table: list[dict[str, str | float]] = []
    for name in names:
        seconds = [each[name].seconds for each in done]
        table.append(
            {
                "command": name,
                "cache": "cold" if cold else "warm",
                "seconds": statistics.median(seconds),
                "fastest": min(seconds),
                "slowest": max(seconds),
                "processor": statistics.median(each[name].processor for each in done),
                "ratio": statistics.median(
                    each[name].seconds / each[REFERENCE].seconds for each in done
                ),
            }
        )
    return table


def main() -> None:
    """Print the table, or JSON."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true")
    parser.add_argument("-n", type=int, default=5, help="rounds")
    parser.add_argument("--warm", action="store_true", help="only with warm caches")
    parser.add_argument("names", nargs="*", help="parts of the names of commands")
    options = parser.parse_args()
    names = [
        name
        for name in COMMANDS
        if name == REFERENCE or not options.names or any(part in name for part in options.names)
    ]
    table = [
        row
        for cold in ((False,) if options.warm else (True, False))
        for row in rows(names, options.n, cold)
    ]
    if options.json:
        print(json.dumps(table, indent=2))
        return
    print(f"{'command':42} {'cache':5} {'s':>6} {'min':>6} {'max':>6} {'cpu':>6} {'ratio':>6}")
    for row in table:
        print(
            f"{row['command']:42} {row['cache']:5} {row['seconds']:6.2f} {row['fastest']:6.2f} "
            f"{row['slowest']:6.2f} {row['processor']:6.2f} {row['ratio']:6.2f}"
        )


if __name__ == "__main__":
    main()
