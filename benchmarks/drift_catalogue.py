"""Drift of the integrals of every catalogue system over 100 000 units of time.

Each system has the start of the catalogue and its default parameters, and is integrated as by
`chaplygin run` (Taylor series, tolerance 1e-15, integrals not corrected), also beyond lift-off.
The given folder has one file per system, which is rewritten after every piece of time; the same
command continues from there.  A system that has used its share of processor seconds is left, and a
later call with a larger share continues it.

    nice python benchmarks/drift_catalogue.py build/drift --share 60
    python benchmarks/drift_catalogue.py build/drift --table
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any

import numpy as np

from chaplygin import RunError, Study, Trajectory, integrate
from chaplygin.experiment.models.experiment import catalogue_experiment
from nonholonomic import CATALOGUE

UNTIL = 1e5
PIECE = 500.0
SAMPLES = 51


def initial_record(study: Study) -> dict[str, Any]:
    """Record of a system before the first step."""
    return {
        "system": study.system.name,
        "time": 0.0,
        "state": [float(x) for x in study.start],
        "first": {},
        "drift": {},
        "steps": 0,
        "seconds": 0.0,
        "end": "",
    }


def record_after(
    record: dict[str, Any], motion: Trajectory, seconds: float, failure: str
) -> dict[str, Any]:
    """Record after another piece of the motion.

    The last sample of a motion that ended at a singularity is not used: there the terms of an
    integral are so large that their sum is only rounding.
    """
    stopped = [h.guard.message for h in motion.events if h.is_terminal]
    end = stopped[0] if stopped else failure
    first, drift = dict(record["first"]), dict(record["drift"])
    for law in motion.system.integrals:
        values = np.asarray(motion.records[f"law_{law.name}"], dtype=float)
        first.setdefault(law.name, float(values[0]))
        good = values[:-1] if end and len(values) > 1 else values
        change = float(np.max(np.abs(good - first[law.name])))
        drift[law.name] = max(drift.get(law.name, 0.0), change)
    return record | {
        "time": float(motion.times[-1]),
        "state": [float(x) for x in motion.states[-1]],
        "first": first,
        "drift": drift,
        "steps": record["steps"] + motion.statistics.steps,
        "seconds": record["seconds"] + seconds,
        "end": end,
    }


def continue_run(study: Study, path: Path, share: float) -> None:
    """Integrate a system until its share of seconds is used or the final time is reached."""
    record = json.loads(path.read_text()) if path.exists() else initial_record(study)
    while record["time"] < UNTIL and not record["end"] and record["seconds"] < share:
        # first up to the duration in the catalogue, because some motions end soon after it
        last = min(record["time"] + PIECE, UNTIL) if record["time"] else study.until
        begin = time.process_time()
        try:
            motion = integrate(
                study.system_on_level,
                record["state"],
                np.linspace(record["time"], last, SAMPLES),
                on_liftoff="warn",
                time_limit=share - record["seconds"],
            )
            failure = ""
        except RunError as error:
            motion, failure = error.partial, error.reason
            if "time limit" in failure:
                failure = ""
        record = record_after(record, motion, time.process_time() - begin, failure)
        new = path.with_suffix(".new")
        new.write_text(json.dumps(record, indent=1))
        new.replace(path)


def relative(record: dict[str, Any]) -> tuple[float, str]:
    """Largest drift, relative to the first value if that exceeds one, and its law."""
    sizes = {n: d / max(1.0, abs(record["first"][n])) for n, d in record["drift"].items()}
    worst = max(sizes, key=lambda name: sizes[name], default="")
    return sizes.get(worst, 0.0), worst


def table(folder: Path) -> str:
    """Markdown table of the records of a folder."""
    lines = ["| system | until | integrals | drift | of | steps | s |", "|---" * 7 + "|"]
    for name in CATALOGUE:
        path = folder / f"{name}.json"
        if path.exists():
            record = json.loads(path.read_text())
            size, worst = relative(record)
            drift, law = (f"{size:.1e}", worst.replace("_", " ")) if worst else ("—", "")
            lines.append(
                f"| {name} | {record['time']:.6g} | {len(record['drift'])} | {drift} | {law} | "
                f"{record['steps']} | {record['seconds']:.3g} |"
            )
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--share", type=float, default=60.0, help="processor seconds for a system")
    parser.add_argument("--only", nargs="*", default=list(CATALOGUE), help="systems")
    parser.add_argument("--table", action="store_true", help="print the table of what is there")
    options = parser.parse_args()
    if options.table:
        print(table(options.folder))
        return
    options.folder.mkdir(parents=True, exist_ok=True)
    for number, name in enumerate(options.only, 1):
        path = options.folder / f"{name}.json"
        print(f"{number}/{len(options.only)} {name}", end=" ", flush=True)
        continue_run(Study.from_experiment(catalogue_experiment(name)), path, options.share)
        record = json.loads(path.read_text())
        size, _ = relative(record)
        print(f"t = {record['time']:g}, drift {size:.1e} {record['end']}", flush=True)


if __name__ == "__main__":
    main()
