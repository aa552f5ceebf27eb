import assert from "node:assert/strict";
import { test } from "node:test";

import type { Estimate } from "../src/data/estimate.ts";
import { axisOf, figuresOf } from "../src/study/comparison.ts";

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

const kExperiments = [
  {
    final_return: estimate(10),
    metrics: [metric("way", "m", estimate(2)), metric("falls", "", estimate(1))],
    terms: [term("forward", estimate(12))],
  },
  {
    final_return: estimate(20),
    metrics: [metric("way", "cm", estimate(300)), metric("falls", "", estimate(4))],
    terms: [term("forward", estimate(21)), term("fall", estimate(-1))],
  },
];

test("what at least two experiments have can be compared, of the same unit", () => {
  const figures = figuresOf(kExperiments);
  assert.deepEqual(
    figures.map(({ name }) => name),
    ["final return", "falls", "return by forward"],
  );
  const [, second = kExperiments[0]] = kExperiments;
  assert.ok(second);
  assert.deepEqual(
    figures.map(({ valueIn }) => valueIn(second)?.mean),
    [20, 4, 21],
  );
  assert.deepEqual(figuresOf(kExperiments.slice(0, 1)), []);
});

test("the axis has all means, intervals and zero", () => {
  assert.deepEqual(axisOf([estimate(3, 1, 9), estimate(12)]), [0, 12]);
  assert.deepEqual(axisOf([estimate(-3, -5, -1)]), [-5, 0]);
  assert.deepEqual(axisOf([estimate(null)]), [0, 1]);
});
