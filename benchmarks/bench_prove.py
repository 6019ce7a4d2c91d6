"""Time to prove an integral, compared with SymPy for the same law of the same system.

SymPy brings dF/dt to a common denominator and reduces its numerator modulo the relations, as in a
calculation by hand; each run is a process of its own with a time limit.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

import sympy as sp

TURNS = 5
LAWS = (
    ("veselova", "momentum"),
    ("chaplygin-ball", "momentum"),
    ("chaplygin-ball", "energy"),
    ("rubber-ball-around-sphere", "quadratic"),
    ("unbalanced-ball", "quadratic"),
    ("unbalanced-rubber-ball", "quadratic"),
    ("rattleback", "energy"),
)


def by_sympy(name: str, law_name: str) -> bool:
    """Proof by a common denominator of dF/dt, with its numerator modulo the relations."""
    from chaplygin import from_catalogue
    from flowlanes.system import to_components
    from lawproof.proof.level.level_set import LevelSet

    system = from_catalogue(name)
    law = next(law for law in system.integrals if law.name == law_name)
    ground = LevelSet(system, law.level)
    value = ground.expand(to_components(law.value))
    rate = sp.Add(
        *(
            sp.diff(value, s) * ground.expand(v)
            for s, v in zip(system.symbols, system.rates, strict=True)
        )
    )
    numerator, _ = sp.fraction(sp.together(rate))
    relations = [sp.fraction(sp.together(ground.expand(c)))[0] for c in ground.conditions]
    moving = system.symbols
    _, rest = sp.reduced(sp.expand(numerator), relations, *moving, order="lex")
    return bool(sp.expand(rest) == 0)


def by_prover(name: str, law_name: str) -> bool:
    """Proof by the prover of this package, without cached verdicts."""
    from chaplygin import from_catalogue, prove

    system = from_catalogue(name)
    law = next(law for law in system.integrals if law.name == law_name)
    return prove(system, law).decision == "proven"


ROADS = {"prover": by_prover, "sympy": by_sympy}


def timed(road: str, name: str, law: str, limit: float) -> float | None:
    """Seconds in a new process with an empty cache; None if it failed or exceeded the limit."""
    with tempfile.TemporaryDirectory() as empty:
        try:
            done = subprocess.run(
                [sys.executable, __file__, "--one", road, name, law],
                capture_output=True,
                text=True,
                timeout=limit,
                check=False,
                env={**os.environ, "FLOWLANES_CACHE": empty},
            )
        except subprocess.TimeoutExpired:
            return None
    found = json.loads(done.stdout) if done.returncode == 0 else {"proven": False}
    return found["seconds"] if found["proven"] else None


def one(road: str, name: str, law: str) -> None:
    """One run, printed for the parent process; the construction of the system is not included."""
    import lawproof.proof.prover  # noqa: F401  (imports are not counted)
    from chaplygin import from_catalogue

    from_catalogue(name)
    began = time.perf_counter()
    proven = ROADS[road](name, law)
    print(json.dumps({"proven": proven, "seconds": time.perf_counter() - began}))


def main() -> None:
    """Measure all laws, with the two provers alternating."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--limit", type=float, default=60.0, help="seconds for one run")
    parser.add_argument("--one", nargs=3, metavar=("ROAD", "NAME", "LAW"))
    options = parser.parse_args()
    if options.one:
        one(*options.one)
        return
    rows = []
    for name, law in LAWS:
        times: dict[str, list[float]] = {road: [] for road in ROADS}
        out_of_time = set()
        for _ in range(TURNS):
            for road, found in times.items():
                if road in out_of_time:
                    continue
                seconds = timed(road, name, law, options.limit)
                if seconds is None:
                    out_of_time.add(road)
                else:
                    found.append(seconds)
        medians = {
            r: statistics.median(f) if f and r not in out_of_time else None
            for r, f in times.items()
        }
        rows.append({"system": name, "law": law, **medians})
        own, peer = medians["prover"], medians["sympy"]
        shown = f"{peer:8.2f} s   {peer / own:6.0f} ×" if own and peer else f"> {options.limit:g} s"
        if not options.json:
            print(f"{name:28} {law:10} {own:8.3f} s   {shown}", flush=True)
    if options.json:
        print(json.dumps(rows, indent=2))


if __name__ == "__main__":
    main()
