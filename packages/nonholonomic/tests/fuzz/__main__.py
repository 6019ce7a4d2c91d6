"""Plant laws, have them judged, and print what came of it.

python -m fuzz --count 5000 --seed 1
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from collections import Counter
from pathlib import Path

from flowlanes.errors import InputError
from fuzz.campaign import Outcome, run, tried
from fuzz.judge import GRAVE, OUTCOMES
from fuzz.planter import FAMILIES, planted_case


def main() -> int:
    """Run a campaign."""
    parser = argparse.ArgumentParser(prog="python -m fuzz", description=__doc__)
    parser.add_argument("--count", type=int, default=5000, help="how many cases")
    parser.add_argument("--first", type=int, default=0, help="number of the first one")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--seconds", type=float, default=30.0, help="after which a case is given up"
    )
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--family", action="append", help="only these", choices=[*FAMILIES])
    parser.add_argument("--show", type=int, help="print the case of a number, and try it here")
    parser.add_argument("--lines", type=int, default=8, help="examples shown of each grave outcome")
    parser.add_argument("--log", type=Path, help="a line for every case goes to this file")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        os.environ["FLOWLANES_CACHE"] = folder
        if given.show is not None:
            return _show(given.seed, given.show)
        numbers = (
            n
            for n in range(given.first, given.first + given.count)
            if not given.family or planted_case(given.seed, n).family in given.family
        )
        found = []
        log = given.log.open("w") if given.log else None
        for outcome in run(given.seed, numbers, given.seconds, given.processes):
            found.append(outcome)
            if log:
                print(*vars(outcome).values(), sep="\t", file=log, flush=True)
            if sys.stderr.isatty():
                print(f"\r{len(found)}", end="", file=sys.stderr)
    print(report(found, given.lines))
    return int(any(o.outcome in GRAVE for o in found))


def _show(seed: int, number: int) -> int:
    case = planted_case(seed, number)
    print(f"{case.family}: {case.truth}, {case.why}")
    try:
        system, law = case.make()
    except InputError as error:
        print(error)
        return 0
    for name, rate in system.field:
        print(f"  {name}' = {rate}")
    for name in ("parameters", "definitions", "relations", "guards"):
        for item in getattr(system, name):
            print(f"  {name}: {item}")
    print(" ", law)
    print("  fails at", case.fails_at)
    print(*tried(case), sep=": ")
    return 0


def report(found: list[Outcome], lines: int) -> str:
    """A table of outcomes, the families they came from, examples, and what took longest."""
    truths = Counter(o.truth for o in found)
    counts = Counter(o.outcome for o in found)
    seconds = sorted(o.seconds for o in found)
    text = [
        f"{len(found)} cases: " + ", ".join(f"{n} {truth}" for truth, n in truths.most_common()),
        f"median {seconds[len(seconds) // 2]:.2f} s, in all {sum(seconds):.0f} s" if found else "",
        "",
    ]
    for outcome, meaning in OUTCOMES.items():
        families = Counter(o.family for o in found if o.outcome == outcome)
        where = ", ".join(f"{name} {n}" for name, n in families.most_common(6))
        shown = meaning if outcome == "right" else where
        text.append(f"{outcome:22}{counts[outcome]:6}  {shown}")
    true = truths["true"] or 1
    share = counts["undecided, true"] / true
    text += ["", f"undecided share of the true ones: {100 * share:.1f} %"]
    for outcome in (*GRAVE, "refused", "too long"):
        examples = [o for o in found if o.outcome == outcome]
        if examples:
            text += ["", f"{outcome}:"]
            text += [
                f"  {o.number:6} {o.family}: {o.told[:110]} | {o.why}" for o in examples[:lines]
            ]
    slowest = sorted(found, key=lambda o: -o.seconds)[:8]
    text += ["", "slowest:"]
    text += [f"  {o.number:6} {o.seconds:6.1f} s  {o.family}: {o.told[:90]}" for o in slowest]
    return "\n".join(text)


if __name__ == "__main__":
    sys.exit(main())
