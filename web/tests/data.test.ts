import assert from "node:assert/strict";
import { test } from "node:test";

import { decodeFloats } from "../src/data/base64.ts";
import { decodeReport } from "../src/data/report_data.ts";
import { commentStart, docOfTask } from "../src/data/task_source.ts";

test("floats are little-endian", () => {
  // 1 = 3f800000, -2.5 = c0200000, NaN = 7fc00000, each from its last byte.
  assert.deepEqual([...decodeFloats("AACAPwAAIMAAAMB/")], [1, -2.5, NaN]);
  assert.equal(decodeFloats("").length, 0);
});

test("data that is cut off is refused", () => {
  assert.throws(() => decodeFloats("AACA"), /cut off/);
});

test("series and poses of a report are decoded", () => {
  const one = "AACAPw==";
  const curve = { name: "fall", unit: "", reduction: "", doc: "", tasks: [0], values: one };
  const recording = { episode: 1, best: true, frames: 1, interval: 0.02, poses: one };
  const report = decodeReport(
    JSON.stringify({
      run: { task: "crawling" },
      episode: one,
      returns: one,
      terms: [curve],
      metrics: [],
      logs: [curve],
      goals: [curve],
      phases: [curve],
      learner: [{ name: "temperature", unit: "", doc: "", values: one }],
      shadows: [{ module: "careful", tasks: [1], values: one }],
      recordings: [recording],
    }),
  );
  assert.equal(report.run["task"], "crawling");
  assert.deepEqual([...(report.terms[0]?.values ?? [])], [1]);
  assert.deepEqual([...(report.logs[0]?.values ?? [])], [1]);
  assert.deepEqual([...(report.goals[0]?.values ?? [])], [1]);
  assert.deepEqual([...(report.learner[0]?.values ?? [])], [1]);
  assert.deepEqual([...(report.shadows[0]?.values ?? [])], [1]);
  assert.deepEqual([...(report.recordings[0]?.poses ?? [])], [1]);
});

test("a comment starts at two slashes outside of strings", () => {
  assert.equal(commentStart("end // why"), 4);
  assert.equal(commentStart('end "a // b" // c'), 13);
  assert.equal(commentStart('"\\"//"'), 6);
  assert.equal(commentStart("no comment"), 10);
});

test("the documentation of a task is its first paragraph", () => {
  const source =
    "// license\n\n/// Move forward\n/// without falling.\n///\n/// More.\ntask crawling\n";
  assert.equal(docOfTask(source), "Move forward without falling.");
  assert.equal(docOfTask("task crawling\n/// late\n"), "");
  assert.equal(docOfTask(""), "");
});
