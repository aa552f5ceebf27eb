import assert from "node:assert/strict";
import { test } from "node:test";

import { changeWords, placeOf } from "../src/charts/change_marks.ts";
import type { Task } from "../src/data/report_data.ts";
import { lastTask, onlyUnder, versionStarts } from "../src/data/versions.ts";

const task = (name: string): Task => ({ module: "task", name, file: "", hash: "", sources: [] });

// Task 0, then 1, then 0 again.
const run = {
  tasks: [task("crawling"), task("careful")],
  episode: Float32Array.of(1, 2, 3, 4, 5),
  versions: [
    { task: 0, first: 1, last: 2 },
    { task: 1, first: 3, last: 4 },
    { task: 0, first: 5, last: 5 },
  ],
};

test("a version starts with each swap", () => {
  assert.deepEqual(versionStarts(run), [2, 4]);
  assert.equal(lastTask(run)?.name, "crawling");
});

test("a curve is kept where its tasks were active", () => {
  const values = Float32Array.of(1, 2, 3, 4, 5);
  assert.deepEqual([...onlyUnder(run, [0], values)], [1, 2, NaN, NaN, 5]);
  assert.deepEqual([...onlyUnder(run, [1], values)], [NaN, NaN, 3, 4, NaN]);
  assert.deepEqual([...onlyUnder(run, [0, 1], values)], [...values]);
});

test("a change between two episodes stands between them", () => {
  const change = { episode: 13, step: 0, at: "", kind: "swap", text: "swap task: a.task" };
  assert.equal(placeOf(change), 12.5);
  assert.equal(changeWords(change), "episode 13: swap task: a.task");
  const within = { ...change, step: 250 };
  assert.equal(placeOf(within), 13);
  assert.equal(changeWords(within), "episode 13, step 250: swap task: a.task");
});
