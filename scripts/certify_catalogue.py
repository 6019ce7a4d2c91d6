"""Certificates of all laws of the catalogue: made, checked, and counted.

    python scripts/certify_catalogue.py [--seconds N] [--out FILE] [SYSTEM ...]

Writes one line of JSON for each law, and a summary at the end.  Exit status 0 whatever is found.
"""

from __future__ import annotations

import argparse
import json
import signal
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any, TextIO

from chaplygin.errors import InputError
from chaplygin.laws.certificate import certified
from chaplygin.statements import Law
from chaplygin.system import System
from chaplygin.systems import CATALOGUE, from_catalogue


class TookTooLongError(Exception):
    """More time than a law may take."""


def main() -> None:
    """Go through the systems, the small ones first."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("systems", nargs="*", metavar="SYSTEM")
    arguments.add_argument("--seconds", type=int, default=60, help="for one law")
    arguments.add_argument("--out", type=Path, help="where lines are added (default: the terminal)")
    given = arguments.parse_args()
    systems = [from_catalogue(name) for name in given.systems or CATALOGUE]
    systems.sort(key=lambda system: len(str(system.rates)) + len(str(system.steps)))
    if given.out is None:
        _all(systems, given.seconds, sys.stdout)
    else:
        with given.out.open("a") as stream:
            _all(systems, given.seconds, stream)


def _all(systems: list[System], seconds: int, stream: TextIO) -> None:
    signal.signal(signal.SIGALRM, _late)
    outcomes: Counter[str] = Counter()
    for system in systems:
        for law in system.laws:
            record = _one(system, law, seconds)
            outcomes["certified" if record["bytes"] else record["why"]] += 1
            print(json.dumps(record), file=stream, flush=True)
    for outcome, count in outcomes.most_common():
        print(f"{count:4d}  {outcome}", file=sys.stderr)


def _late(*_: Any) -> None:
    raise TookTooLongError


def _one(system: System, law: Law, seconds: int) -> dict[str, Any]:
    started = time.monotonic()
    record = {"system": system.name, "law": law.name, "kind": type(law).__name__, "bytes": 0}
    signal.alarm(seconds)
    try:
        verdict = certified(system, law)
    except TookTooLongError:
        record |= {"decision": "", "why": f"not done in {seconds} s"}
    except InputError as error:
        record |= {"decision": "", "why": str(error)}
    else:
        record |= {"decision": verdict.decision, "why": verdict.uncertified or verdict.reason}
        if verdict.certificate is not None:
            record["bytes"] = len(json.dumps(verdict.certificate))
    finally:
        signal.alarm(0)
    record["seconds"] = round(time.monotonic() - started, 2)
    return record


if __name__ == "__main__":
    main()
