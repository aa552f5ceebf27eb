import assert from "node:assert/strict";
import { test } from "node:test";

import { type Estimate, interval, mean, range } from "../src/data/estimate.ts";
import { decodeStudy, type Experiment, type Group } from "../src/study/data.ts";
import { moved, preferCommand, quoted } from "../src/study/preference_words.ts";
import { colorOf, count, shareOf } from "../src/study/words.ts";

const one = "AACAPw=="; // 1
const known: Estimate = { count: 3, mean: 2, low: -1, high: 5, least: 1, greatest: 3 };
const unknown: Estimate = {
  count: 1,
  mean: 2,
  low: null,
  high: null,
  least: 2,
  greatest: 2,
};

test("curves and replays of a study are decoded", () => {
  const recording = { episode: 40, frames: 1, interval: 0.02, poses: one };
  const study = decodeStudy(
    JSON.stringify({
      folder: "six-tasks",
      experiments: [
        {
          curve: { episodes: one, mean: one, low: one, high: one },
          metricCurves: [{ name: "way", unit: "m", mean: one, low: one, high: one }],
          termCurves: [],
          runs: [{ name: "seed1", curve: one }],
          groups: [{ runs: [0], recording }, { runs: [1] }],
        },
      ],
    }),
  );
  const experiment = study.experiments[0];
  assert.deepEqual([...(experiment?.curve.low ?? [])], [1]);
  assert.deepEqual([...(experiment?.metricCurves[0]?.high ?? [])], [1]);
  assert.deepEqual([...(experiment?.runs[0]?.curve ?? [])], [1]);
  assert.deepEqual([...(experiment?.groups[0]?.recording?.poses ?? [])], [1]);
  assert.equal(experiment?.groups[1]?.recording, undefined);
});

test("an estimate is told with what is known of it", () => {
  assert.equal(mean(known), "2.000");
  assert.equal(interval(known), "−1.000 … 5.000");
  assert.equal(interval(unknown), "");
  assert.equal(range(known, count), "1 … 3");
  assert.equal(range(unknown), "");
  assert.equal(count(undefined), "–");
});

test("a group is told with its share of the runs", () => {
  const group = { runs: [0, 3], share: 2 / 7 } as Group;
  assert.equal(shareOf(group), "2 of 7 runs, 29 %");
});

test("groups are colored", () => {
  assert.equal(colorOf(0), "--series-1");
  assert.equal(colorOf(8), "--series-1");
  assert.equal(colorOf(null), "--ink-faint");
});

test("an order of groups is a command line", () => {
  const experiment = {
    groups: [{ typical: 2 }, { typical: 0 }],
    runs: [{ name: "crawling/seed1" }, {}, { name: "it's/seed3" }],
  } as Experiment;
  assert.equal(
    preferCommand("runs/my study", experiment, [1, 0]),
    "trainer prefer 'runs/my study' --order crawling/seed1 'it'\\''s/seed3'",
  );
  assert.equal(quoted("runs/six-tasks"), "runs/six-tasks");
  assert.equal(quoted(""), "''");
});

test("a group moves up and down, but not out of the list", () => {
  assert.deepEqual(moved(["a", "b", "c"], 2, -1), ["a", "c", "b"]);
  assert.deepEqual(moved(["a", "b", "c"], 0, 1), ["b", "a", "c"]);
  assert.deepEqual(moved(["a", "b", "c"], 0, -1), ["a", "b", "c"]);
  assert.deepEqual(moved(["a", "b", "c"], 2, 1), ["a", "b", "c"]);
});
