import assert from "node:assert/strict";
import { test } from "node:test";

import type { Estimate } from "../src/data/estimate.ts";
import { axisOf, figuresOf } from "../src/study/comparison.ts";
import { commonEpisodes, valuesAt } from "../src/study/overlay.ts";

const estimate = (mean: number | null, low: number | null = null, high = low): Estimate => ({
  count: 3,
  mean,
  low,
  high,
  least: mean,
  greatest: mean,
});

const metric = (name: string, unit: string, value: Estimate) => ({
  ...{ name, unit, value },
  ...{ reduction: "last", doc: "" },
});
const term = (name: string, value: Estimate) => ({ name, doc: "", value, share: null });

const floats = (...values: number[]): Float32Array => Float32Array.from(values);
const means = (value: number) => ({ mean: floats(value), low: floats(NaN), high: floats(NaN) });
const curve = (name: string, unit: string, value: number) => ({ name, unit, ...means(value) });

const kExperiments = [
  {
    curve: { episodes: floats(1), ...means(9) },
    metricCurves: [curve("way", "m", 2), curve("falls", "", 1)],
    termCurves: [curve("forward", "", 12)],
    final_return: estimate(10),
    metrics: [metric("way", "m", estimate(2)), metric("falls", "", estimate(1))],
    terms: [term("forward", estimate(12))],
  },
  {
    curve: { episodes: floats(1), ...means(19) },
    metricCurves: [curve("way", "cm", 300), curve("falls", "", 5)],
    termCurves: [curve("forward", "", 22), curve("fall", "", -1)],
    final_return: estimate(20),
    metrics: [metric("way", "cm", estimate(300)), metric("falls", "", estimate(4))],
    terms: [term("forward", estimate(21)), term("fall", estimate(-1))],
  },
];

test("what at least two experiments have can be compared, of the same unit", () => {
  const figures = figuresOf(kExperiments);
  assert.deepEqual(
    figures.map(({ name }) => name),
    ["return", "falls", "return by forward"],
  );
  const [, second = kExperiments[0]] = kExperiments;
  assert.ok(second);
  assert.deepEqual(
    figures.map(({ valueIn }) => valueIn(second)?.mean),
    [20, 4, 21],
  );
  assert.deepEqual(
    figures.map(({ curveIn }) => curveIn(second)?.mean[0]),
    [19, 5, 22],
  );
  assert.deepEqual(figuresOf(kExperiments.slice(0, 1)), []);
});

test("the axis has all means, intervals and zero", () => {
  assert.deepEqual(axisOf([estimate(3, 1, 9), estimate(12)]), [0, 12]);
  assert.deepEqual(axisOf([estimate(-3, -5, -1)]), [-5, 0]);
  assert.deepEqual(axisOf([estimate(null)]), [0, 1]);
});

test("curves of other episodes are shown at common ones, each as far as it goes", () => {
  const short = floats(2, 4);
  const long = floats(3, 6, 9);
  assert.deepEqual([...commonEpisodes([short, long])], [2, 3, 4, 6, 9]);
  const wanted = commonEpisodes([short, long]);
  assert.deepEqual([...valuesAt(wanted, short, floats(10, 20))], [10, 15, 20, NaN, NaN]);
  assert.deepEqual([...valuesAt(wanted, long, floats(0, 30, NaN))], [NaN, 0, 10, 30, NaN]);
  const many = Float32Array.from({ length: 2000 }, (_, i) => i + 1);
  const common = commonEpisodes([many, floats(7, 1111)]);
  assert.ok(common.length <= 503);
  assert.equal(common.at(-1), 2000);
  assert.ok(common.includes(1111));
});
