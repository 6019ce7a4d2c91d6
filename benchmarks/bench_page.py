"""Speed of a page compared with native code: one motion, a section, indicators of chaos.

The engine of the page runs in Node, native code on one thread; both alternate, and the results are
medians.  A motion has 601 samples, as for a slider; a section has 1,000 points, as for a click;
the indicator is MEGNO to t = 100, per motion, for as many motions as in a tile of a chart in the
page, and natively for a row of a chart.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
import time
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from statistics import median

import numpy as np

from chaplygin import Study, parse_experiment
from chaplygin.page.page_model import live_page_model
from chaplygin.page.page_systems import page_system, reduced_system
from chaplygin.page.wasm_module import page_module
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.lyapunov.indicators import megno

SYSTEMS = ("unbalanced-ball", "rubber-body", "marble-ball-on-torus", "clebsch")
SAMPLES, POINTS, UNTIL, TILE, ROW = 601, 1000, 100.0, 8, 200

_PROGRAM = """
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
const { WasmEngine } = await import(%s);
const model = JSON.parse(readFileSync(process.argv[1], "utf8"));
const began = performance.now();
const engine = await WasmEngine.create(model);
console.log(performance.now() - began);
for await (const line of createInterface({ input: process.stdin })) {
  const [method, task] = JSON.parse(line);
  const from = performance.now();
  await engine[method](task);
  console.log(performance.now() - from);
}
"""


class Page:
    """Engine in a process of its own."""

    def __init__(self, model: dict[str, object], folder: str) -> None:
        path = Path(folder) / "model.json"
        path.write_text(json.dumps(model))
        engine = (Path(str(files("chaplygin.page"))) / "static" / "engine.js").as_uri()
        self.process = subprocess.Popen(
            ["node", "--input-type=module", "-e", _PROGRAM % json.dumps(engine), str(path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.start = self._answer()

    def _answer(self) -> float:
        return float(self.process.stdout.readline()) / 1e3

    def seconds(self, method: str, task: dict[str, object]) -> float:
        """Duration of a call in that process."""
        self.process.stdin.write(json.dumps([method, task]) + "\n")
        self.process.stdin.flush()
        return self._answer()

    def end(self) -> None:
        self.process.stdin.close()
        self.process.wait()


def seconds(act: Callable[[], object]) -> float:
    began = time.perf_counter()
    act()
    return time.perf_counter() - began


def compared(page: Callable[[], float], native: Callable[[], object], times: int) -> list[float]:
    """Medians of both in ms, measured alternately."""
    page(), native()
    pairs = [(page(), seconds(native)) for _ in range(times)]
    return [1e3 * median(column) for column in zip(*pairs, strict=True)]


def per_motion(both: list[float]) -> list[float]:
    page, native = both
    return [page / TILE, native / ROW]


def row(name: str, times: int) -> dict[str, object]:
    study = Study.from_experiment(parse_experiment(f'system = {{name = "{name}"}}'))
    compile_seconds = seconds(lambda: page_module(study))
    model = live_page_model(study)
    module = page_module(study)
    system, reduced = page_system(study), reduced_system(study)
    whole = system.lifted() if system.reconstruction else system
    start = np.array([[float(x) for x in study.start]])
    here = start[:, : len(reduced.symbols)]
    moments = np.linspace(0.0, study.until, SAMPLES)
    section = model["section"]
    text = next(q["formula"] for q in model["quantities"] if q["name"] == section["on"])
    cut = poincare_section(reduced, text, section["value"], 1)
    motions = batch_integrator(whole, tolerance=model["tolerance"])
    returns = batch_integrator(reduced, section=cut)
    growth = megno(reduced, UNTIL)
    many = np.repeat(here, ROW, axis=0)
    common = {"parameters": {}, "start": model["start"]}
    tile = {"motions": [common] * TILE, "until": UNTIL, "kind": "megno"}
    with tempfile.TemporaryDirectory() as folder:
        page = Page(model, folder)
        results = {
            "motion": compared(
                lambda: page.seconds("motion", {**common, "times": moments.tolist()}),
                lambda: motions.propagate(start, moments, threads=1),
                times,
            ),
            "section": compared(
                lambda: page.seconds("section", {**common, **section, "points": POINTS}),
                lambda: returns.crossings(here, POINTS, threads=1),
                times,
            ),
            "megno": per_motion(
                compared(lambda: page.seconds("indicators", tile), lambda: growth(many, {}), times)
            ),
        }
        started = page.start
        page.end()
    return {
        "system": name,
        "compile_s": compile_seconds,
        "module_kB": len(module.code) / 1e3,
        "deflated_kB": len(str(model["wasm"])) / 1e3,
        "open_ms": 1e3 * started,
        **{f"{what}_ms": pair for what, pair in results.items()},
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--quick", action="store_true", help="the first system alone")
    options = parser.parse_args()
    rows = []
    for name in SYSTEMS[: 1 if options.quick else None]:
        rows.append(row(name, 5 if options.quick else 15))
        if options.json:
            continue
        one = rows[-1]
        print(
            f"{name}: compiled in {one['compile_s']:.1f} s, {one['module_kB']:.0f} kB, "
            f"{one['deflated_kB']:.0f} kB in the page, open in {one['open_ms']:.0f} ms"
        )
        for what in ("motion", "section", "megno"):
            page, native = one[f"{what}_ms"]
            ratio = page / native
            print(f"  {what:<8} page {page:9.2f} ms, native {native:9.2f} ms, ratio {ratio:.2f}")
    if options.json:
        print(json.dumps(rows))


if __name__ == "__main__":
    main()
