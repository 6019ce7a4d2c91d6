import assert from "node:assert/strict";
import { test } from "node:test";
import type { PageModel } from "../src/model";
import { Cell, latest } from "../src/page/cell";
import { changed, fromFragment, History, instants, opening, same, toFragment, type Experiment } from "../src/page/experiment";
import { axisTexts, extent, readable, readableBeside, readableOn, roundNumber, ticks, tickTexts } from "../src/page/numbers";
import { unitText } from "../src/page/units";
import { onScale } from "../src/page/palette";
import { font } from "../src/page/type";

const model = {
  until: 10,
  parameters: [{ name: "I_1" }],
  start_inputs: [{ name: "omega_3" }],
  state: [{ name: "M_1" }, { name: "M_2" }],
} as unknown as PageModel;

test("numbers are written as in print", () => {
  assert.equal(readable(0), "0");
  assert.equal(readable(-1.5), "−1.5");
  assert.equal(readable(3.2e-7), "3.2 × 10⁻⁷");
  assert.equal(readable(-2e12), "−2 × 10¹²");
  assert.equal(readable(1200), "1200");
  assert.equal(readable(0.1 + 0.2), "0.3");
  assert.equal(readable(NaN), "–");
});

test("rounding beside larger values reads zero", () => {
  assert.equal(readableBeside(1, 4e-25), "0");
  assert.equal(readableBeside(1, -4e-13), "0");
  assert.equal(readableBeside(1, 4e-9), "4 × 10⁻⁹");
  assert.equal(readableBeside(4e-25, 4e-25), "4 × 10⁻²⁵");
  assert.equal(readableBeside(0, 4e-25), "4 × 10⁻²⁵");
  assert.equal(readableBeside(1, NaN), "–");
  assert.equal(readableOn([-2, 1], 1e-17), "0");
  assert.equal(readableOn([0, 1e-17], 1e-17), "1 × 10⁻¹⁷");
});

test("fonts of plots have whole sizes", () => {
  assert.match(font(12.8), /^13px /);
  assert.match(font(14), /^14px /);
});

test("units have raised exponents", () => {
  assert.equal(unitText("kg m^2/s"), "kg m²/s");
  assert.equal(unitText("s**-1"), "s⁻¹");
  assert.equal(unitText("1"), "");
});

test("marks on an axis are round, inside and about as many as wished", () => {
  for (const [low, high] of [[0, 1], [-3.14, 3.14], [0.00021, 0.00034], [-1e6, 2.5e6], [99.9, 100.1]] as const) {
    const marks = ticks(low, high, 6);
    assert.ok(marks.length >= 3 && marks.length <= 9, `${marks.length} marks`);
    for (const mark of marks) assert.ok(mark >= low - 1e-9 * Math.abs(low) && mark <= high + 1e-9 * Math.abs(high));
  }
  assert.deepEqual(ticks(0, 1, 5), [0, 0.2, 0.4, 0.6, 0.8, 1]);
  assert.equal(roundNumber(0.07), 0.05);
});

test("a range shows all values, and a whole one where they are alike", () => {
  assert.deepEqual(extent([1, 3, NaN, 2], 0), [1, 3]);
  assert.deepEqual(extent([5, 5]), [4.5, 5.5]);
  assert.deepEqual(extent([]), [-1, 1]);
});

test("an experiment survives the way through the address of a page", () => {
  const given: Experiment[] = [
    opening(model),
    { parameters: { I_1: 1.2345678901234567 }, start: { inputs: { omega_3: -5 } }, until: 20 },
    { parameters: {}, start: { state: [0.1, -1e-300] }, until: 10 },
  ];
  for (const experiment of given) {
    const fragment = toFragment(experiment, model, {});
    const back = fragment === "" ? { experiment: opening(model) } : fromFragment(fragment, model);
    assert.ok(back !== null && same(back.experiment, experiment), fragment);
  }
  assert.equal(fromFragment(toFragment(opening(model), model, { t: "2.5" }), model)?.choices["t"], "2.5");
});

test("an address that this model does not understand is none", () => {
  for (const fragment of ["#motion", "#lab&p.I_9=1", "#lab&p.m=2", "#lab&p.I_1=nonsense", "#lab&s.omega_1=1", "#lab&state=1", "#lab&state=1+x", "#lab&until=-1"]) {
    assert.equal(fromFragment(fragment, model), null, fragment);
  }
});

test("values that are again those of the model are left out", () => {
  assert.deepEqual(changed({ a: 1 }, "b", 2, 3), { a: 1, b: 2 });
  assert.deepEqual(changed({ a: 1, b: 2 }, "b", 3, 3), { a: 1 });
});

test("undo and redo go back and forth, and a change ends redo", () => {
  const history = new History<number>(2);
  for (const value of [0, 1, 2]) history.push(value);
  let now = 3;
  now = history.undo(now) ?? now;
  assert.equal(now, 2);
  assert.equal(history.redo(now), 3);
  assert.equal(history.undo(3), 2);
  assert.equal(history.undo(2), 1);
  assert.equal(history.undo(1), undefined);
  history.push(1);
  assert.equal(history.canRedo, false);
});

test("watchers hear changes, and only changes", () => {
  const cell = new Cell(1);
  const heard: number[] = [];
  const end = cell.watch((value) => heard.push(value));
  cell.value = 1;
  cell.value = 2;
  end();
  cell.value = 3;
  assert.deepEqual(heard, [1, 2]);
});

test("of requests during work only the last is done", async () => {
  const done: number[] = [];
  const work = latest(async (n: number) => {
    await new Promise((resolve) => setTimeout(resolve, 5));
    done.push(n);
    return n;
  });
  const answers = await Promise.all([work(1), work(2), work(3)]);
  assert.deepEqual(done, [1, 3]);
  assert.deepEqual(answers, [undefined, undefined, 3]);
});

test("instants are even and end where they should", () => {
  assert.deepEqual(Array.from(instants(2, 5)), [0, 0.5, 1, 1.5, 2]);
});

test("a scale gives its ends and what is between", () => {
  const scale = ["#000000", "#ff0000", "#ffffff"];
  assert.deepEqual(onScale(scale, 0), [0, 0, 0]);
  assert.deepEqual(onScale(scale, 1), [255, 255, 255]);
  assert.deepEqual(onScale(scale, 0.25), [128, 0, 0]);
});

test("marks on an axis read differently, however near they are", () => {
  assert.deepEqual(tickTexts([1.036141, 1.036142, 1.036143]), ["1.036141", "1.036142", "1.036143"]);
  assert.deepEqual(tickTexts([-0.5, 0, 0.5]), ["−0.5", "0", "0.5"]);
  assert.deepEqual(tickTexts([2e-7]), ["2 × 10⁻⁷"]);
  assert.equal(new Set(tickTexts(ticks(1.03614, 1.03615, 6))).size, ticks(1.03614, 1.03615, 6).length);
});

test("small and large marks have a power of ten in common, in the label of the axis", () => {
  assert.deepEqual(axisTexts([1e-5, 1.5e-5, 2e-5], "M₃  (kg m²/s)"), { texts: ["1", "1.5", "2"], label: "M₃  (10⁻⁵ kg m²/s)" });
  assert.deepEqual(axisTexts([-2e6, 0], "h"), { texts: ["−2", "0"], label: "h  (10⁶)" });
  assert.deepEqual(axisTexts([0, 0.5], "h"), { texts: ["0", "0.5"], label: "h" });
});
