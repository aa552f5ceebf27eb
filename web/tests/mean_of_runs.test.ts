import assert from "node:assert/strict";
import { test } from "node:test";

import { meanOfRuns, quantileOfT } from "../src/data/mean_of_runs.ts";

const isAbout = (value: number | undefined, wanted: number): void =>
  assert.ok(Math.abs((value ?? NaN) - wanted) < 1e-3, `${value} is ${wanted}`);

test("the quantiles are those of the tables", () => {
  isAbout(quantileOfT(1), 12.706);
  isAbout(quantileOfT(30), 2.042);
  isAbout(quantileOfT(31), 2.0395);
  isAbout(quantileOfT(60), 2.0003);
  isAbout(quantileOfT(1000), 1.9623);
});

test("the mean of runs has an interval where there are two of them", () => {
  const { mean, low, high } = meanOfRuns([
    Float32Array.of(1, 2, NaN, 4),
    Float32Array.of(3, 2, 5),
    Float32Array.of(5, 2),
  ]);
  assert.deepEqual([...mean], [3, 2, 5, 4]);
  // The deviation of 1, 3, 5 is 2: 4.303 * 2 / sqrt(3).
  isAbout(high[0], 3 + 4.9687);
  isAbout(low[0], 3 - 4.9687);
  assert.deepEqual([low[1], high[1]], [2, 2]);
  assert.ok(Number.isNaN(low[2]) && Number.isNaN(high[3]));
});
