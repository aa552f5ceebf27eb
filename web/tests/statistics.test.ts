import assert from "node:assert/strict";
import { test } from "node:test";

import { indexOfMaximum, lastValues, runningMean, usualWindow } from "../src/data/statistics.ts";

test("the running mean looks back", () => {
  assert.deepEqual([...runningMean([1, 3, 5, 11], 2)], [1, 2, 4, 8]);
  assert.deepEqual([...runningMean([1, 3], 1)], [1, 3]);
});

test("missing values leave the mean of the others", () => {
  assert.deepEqual([...runningMean([2, NaN, 4, NaN, NaN], 2)], [2, 2, 4, 4, NaN]);
});

test("the running mean begins anew where it is told", () => {
  assert.deepEqual([...runningMean([1, 3, 10, 20, 30], 2, [2])], [1, 2, 10, 15, 25]);
});

test("after a start the mean waits for half of its window, or of what there is", () => {
  assert.deepEqual([...runningMean([8, 1, 3, 5, 7, 9], 4, [1])], [8, NaN, 2, 3, 4, 6]);
  assert.deepEqual([...runningMean([8, 1, 3, 5], 100, [1])], [8, NaN, 2, 3]);
  assert.deepEqual([...runningMean([8, 1, 3], 100, [1, 2])], [8, 1, 3]);
  assert.deepEqual([...runningMean([NaN, 1, 3, 5, 7], 4)], [NaN, NaN, 2, 3, 4]);
});

test("the usual window grows with the run", () => {
  assert.deepEqual([1, 29, 30, 999, 1e6].map(usualWindow), [1, 1, 3, 50, 1000]);
});

test("mean and deviation are those of the last values", () => {
  assert.deepEqual(lastValues([100, 2, NaN, 6], 3), { mean: 4, deviation: 2 });
});

test("the first of the greatest values is the best one", () => {
  assert.equal(indexOfMaximum([NaN, 1, 5, 5, -2]), 2);
  assert.equal(indexOfMaximum([NaN]), -1);
  assert.equal(indexOfMaximum([-7]), 0);
});
