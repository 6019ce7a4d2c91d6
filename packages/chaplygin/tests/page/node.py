"""The engine of a page, run by Node; without Node such tests are skipped."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path

import numpy as np

from needs import needs

NODE = shutil.which("node")

needs_node = needs("node")

_PROGRAM = """
const { WasmEngine } = await import(%s);
const text = await new Promise((done) => {
  let all = "";
  process.stdin.on("data", (part) => (all += part)).on("end", () => done(all));
});
const { model, tasks } = JSON.parse(text);
const engine = await WasmEngine.create(model);
const plain = (key, value) => {
  if (ArrayBuffer.isView(value)) return Array.from(value);
  return typeof value === "number" && !Number.isFinite(value) ? String(value) : value;
};
const results = [];
for (const [name, task] of tasks) {
  try {
    results.push(await engine[name](...task));
  } catch (error) {
    results.push({ error: String(error) });
  }
}
process.stdout.write(JSON.stringify(results, plain));
"""


@cache
def engine_file() -> str:
    return Path(str(files("chaplygin.page") / "static" / "engine.js")).as_uri()


def run_engine(model: Mapping[str, object], *tasks: tuple[str, list[object]]) -> list[object]:
    """Results of methods of the engine, one after another, by their arguments."""
    assert NODE is not None
    done = subprocess.run(
        [NODE, "--input-type=module", "-e", _PROGRAM % json.dumps(engine_file())],
        input=json.dumps({"model": model, "tasks": tasks}, allow_nan=False),
        capture_output=True,
        check=False,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def rows(numbers: list[object], width: int) -> np.ndarray:
    """Numbers of a result, row by row."""
    return np.array([float(x) for x in numbers]).reshape(-1, width)
