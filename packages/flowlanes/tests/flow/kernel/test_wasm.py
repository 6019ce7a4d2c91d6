"""Formulas in WebAssembly, against numbers of many digits."""

from __future__ import annotations

import json
import subprocess
from fractions import Fraction

import mpmath
import numpy as np

from flowlanes.flow.kernel.wasm import emit_row_functions, wasm_module, with_prefix
from flowlanes.flow.machine_code.arithmetic import WithoutFused
from flowlanes.flow.machine_code.ir_writer import IRWriter
from flowlanes.formulas.graph import Graph
from needs import needs

pytestmark = needs("node")

PROGRAM = """
const memory = new WebAssembly.Memory({ initial: 64 });
const { code, rows, inputs, outputs, name } = JSON.parse(require("fs").readFileSync(0, "utf8"));
WebAssembly.instantiate(Buffer.from(code, "hex"), { env: { memory } }).then(({ instance }) => {
  const count = rows.length / inputs;
  new Float64Array(memory.buffer, 1024, rows.length).set(rows);
  const results = 1024 + 8 * rows.length;
  const work = results + 8 * count * outputs;
  instance.exports[name](BigInt(count), 1024, work, results, work);
  const numbers = new Float64Array(memory.buffer, results, count * outputs);
  console.log(JSON.stringify(Array.from(numbers, String)));
});
"""

FUNCTIONS = ["sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log"]


def evaluated(terms, rows):
    """Terms of two state variables at rows of these."""
    text, names, _ = emit_row_functions("of", {"all": terms}, rows.shape[1])
    code = wasm_module([text], list(names.values()))
    task = {
        "code": code.hex(),
        "rows": rows.ravel().tolist(),
        "inputs": rows.shape[1],
        "outputs": len(terms),
        "name": names["all"],
    }
    done = subprocess.run(
        ["node", "-e", PROGRAM], input=json.dumps(task), capture_output=True, check=True, text=True
    )
    return np.array([float(x) for x in json.loads(done.stdout)]).reshape(len(rows), len(terms))


def test_functions_are_right_to_a_digit():
    graph = Graph()
    x, y = graph.state(0), graph.state(1)
    terms = [graph.call(name, x) for name in FUNCTIONS] + [graph.call("atan2", y, x)]
    random = np.random.default_rng(3)
    rows = np.concatenate([random.uniform(-s, s, (60, 2)) for s in (1.0, 30.0, 600.0, 1e5)])
    values = evaluated(terms, rows)
    for row, (a, b) in zip(values, rows.tolist(), strict=True):
        exact = [getattr(mpmath, name)(mpmath.mpf(a)) for name in FUNCTIONS]
        exact.append(mpmath.atan2(b, a))
        for got, value in zip(row, exact, strict=True):
            if isinstance(value, mpmath.mpc):
                assert np.isnan(got)
            elif abs(value) > 1.7e308:
                assert np.isinf(got)
            elif abs(value) > 1e-300:
                assert abs(mpmath.mpf(float(got)) - value) <= 1.01 * np.spacing(float(abs(value)))


def test_formulas_keep_what_rounding_takes_where_it_is_wanted():
    """a b + c by split products, where the product nearly cancels c."""
    w = IRWriter(1)
    k = WithoutFused(w)
    a, b, c = (k.load("%state", i) for i in range(3))
    k.store(k.fma(a, b, c), "%result", 0)
    k.store(k.multiply_add(a, b, c), "%result", 1)
    head = "internal void @all(ptr noalias %result, ptr noalias %state, ptr noalias %constants)"
    graph = Graph()
    loops, names, _ = emit_row_functions("of", {"all": [graph.state(0), graph.state(1)]}, 3)
    start = loops.index("define internal void @of_all(")
    text = (
        loops[:start]
        + with_prefix("of", w.text(head, "#1"))
        + loops[loops.index("}\n", start) + 2 :]
    )
    random = np.random.default_rng(4)
    factors = random.uniform(1.0, 2.0, (200, 2))
    rows = np.column_stack([factors, -factors[:, 0] * factors[:, 1]])
    task = {
        "code": wasm_module([text], list(names.values())).hex(),
        "rows": rows.ravel().tolist(),
        "inputs": 3,
        "outputs": 2,
        "name": names["all"],
    }
    done = subprocess.run(
        ["node", "-e", PROGRAM], input=json.dumps(task), capture_output=True, check=True, text=True
    )
    values = np.array([float(x) for x in json.loads(done.stdout)]).reshape(-1, 2)
    for (p, q, r), (whole, rounded) in zip(rows.tolist(), values.tolist(), strict=True):
        assert Fraction(whole) == Fraction(p) * Fraction(q) + Fraction(r)
        assert rounded == 0.0
