"""Certificates of all laws of the catalogue, or of the audit: generation, check, and statistics.

    python scripts/certify.py [--audit] [--seconds N] [--out FILE] [SYSTEM or SECTION ...]

Writes one line of JSON for each law, and a summary at the end.  The exit status is always 0.
"""

from __future__ import annotations

import argparse
import json
import signal
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any, TextIO

from borisov_mamaev_2008 import claims
from flowlanes.errors import InputError
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from lawproof.proof.certificates.certificate import prove_with_certificate
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE, from_catalogue

Named = tuple[str, System, Law]
"""Where a law stands, its system, and the law."""


class TookTooLongError(Exception):
    """Raised if a law takes more time than allowed."""


def main() -> None:
    """Process the laws, in the catalogue from small to large systems."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("names", nargs="*", metavar="SYSTEM or SECTION")
    arguments.add_argument("--audit", action="store_true", help="the paper's claims instead")
    arguments.add_argument("--seconds", type=int, default=60, help="for one law")
    arguments.add_argument("--out", type=Path, help="where lines are added (default: the terminal)")
    given = arguments.parse_args()
    laws = _audited(given.names) if given.audit else _of_catalogue(given.names)
    if given.out is None:
        _all(laws, given.seconds, sys.stdout)
    else:
        with given.out.open("a") as stream:
            _all(laws, given.seconds, stream)


def _of_catalogue(names: list[str]) -> Iterator[Named]:
    systems = [from_catalogue(name) for name in names or CATALOGUE]
    systems.sort(key=lambda system: len(str(system.rates)) + len(str(system.scalar_definitions)))
    for system in systems:
        for law in system.laws:
            yield system.name, system, law


def _audited(sections: list[str]) -> Iterator[Named]:
    """Laws behind every claim that is proven or refuted; some claims are decided otherwise."""
    for section in map(int, sections) if sections else (None,):
        for number, claim in claims(section):
            for form in (claim.printed, claim.corrected):
                case = form() if form else None
                if case is None or isinstance(case, Verdict):
                    continue
                pairs = case if isinstance(case[0], tuple) else (case,)
                which = "printed" if form is claim.printed else "corrected"
                for system, law in pairs:
                    yield f"§{number} {claim.source}, {which}", system, law


def _all(laws: Iterator[Named], seconds: int, stream: TextIO) -> None:
    signal.signal(signal.SIGALRM, _late)
    outcomes: Counter[str] = Counter()
    for name, system, law in laws:
        record = {"system": name, **_one(system, law, seconds)}
        outcomes["certified" if record["bytes"] else record["why"]] += 1
        print(json.dumps(record, ensure_ascii=False), file=stream, flush=True)
    for outcome, count in outcomes.most_common():
        print(f"{count:4d}  {outcome}", file=sys.stderr)


def _late(*_: Any) -> None:
    raise TookTooLongError


def _one(system: System, law: Law, seconds: int) -> dict[str, Any]:
    started = time.monotonic()
    record: dict[str, Any] = {"law": law.name, "kind": type(law).__name__, "bytes": 0}
    signal.alarm(seconds)
    try:
        verdict = prove_with_certificate(system, law)
    except TookTooLongError:
        record |= {"decision": "", "why": f"not done in {seconds} s"}
    except InputError as error:
        record |= {"decision": "", "why": str(error)}
    else:
        record |= {"decision": verdict.decision, "why": verdict.no_certificate or verdict.reason}
        if verdict.certificate is not None:
            record["bytes"] = len(json.dumps(verdict.certificate))
    finally:
        signal.alarm(0)
    record["seconds"] = round(time.monotonic() - started, 2)
    return record


if __name__ == "__main__":
    main()
