import assert from "node:assert/strict";
import { test } from "node:test";

import {
  agentInWords,
  formatCount,
  formatDate,
  formatDuration,
  formatEstimate,
  formatThousandths,
  formatNumber,
  formatRatio,
  formatTick,
  formatTime,
} from "../src/data/words.ts";

test("numbers have about four digits and a real minus", () => {
  assert.equal(formatNumber(0), "0.000");
  assert.equal(formatNumber(-12.345), "\u221212.35");
  assert.equal(formatNumber(219.94), "219.9");
  assert.equal(formatNumber(123456), "123\u202f456");
  assert.equal(formatNumber(-4e-9), "\u22124.00e\u22129");
  assert.equal(formatNumber(NaN), "–");
  assert.equal(formatNumber(undefined), "–");
});

test("numbers on an axis lose zeros that say nothing, but none of an exponent", () => {
  const ticks = [0, -0.5, 2.5, -12000].map(formatTick);
  assert.deepEqual(ticks, ["0", "\u22120.5", "2.5", "\u221212\u202f000"]);
  const tiny = [1e-10, -1.5e-10, 2e20].map(formatTick);
  assert.deepEqual(tiny, ["1e\u221210", "\u22121.5e\u221210", "2e+20"]);
});

test("lengths have millimeters and no negative zero", () => {
  assert.equal(formatThousandths(-2.57e-9), "0.000");
  assert.equal(formatThousandths(-0.0336), "\u22120.034");
});

test("counts are grouped from five digits on", () => {
  assert.equal(formatCount(2000), "2000");
  assert.equal(formatCount(-30000), "\u221230\u202f000");
});

test("ratios are of two digits or whole", () => {
  assert.equal(formatRatio(4.94), "4.9");
  assert.equal(formatRatio(9.96), "10");
  assert.equal(formatRatio(131.6), "132");
});

test("durations name their two largest units", () => {
  assert.equal(formatDuration(12.5), "12.50 s");
  assert.equal(formatDuration(61), "1 min 1 s");
  assert.equal(formatDuration(15 * 3600 + 61), "15 h 1 min");
  assert.equal(formatDuration(59.9999), "60.00 s");
  assert.equal(formatEstimate(12.5), "13 s");
  assert.equal(formatEstimate(72.4), "1 min 12 s");
  assert.equal(formatEstimate(29 * 60 + 45), "30 min");
  assert.equal(formatEstimate(3599), "1 h 0 min");
  assert.equal(formatEstimate(15 * 3600 + 61), "15 h");
  assert.equal(formatEstimate(NaN), "–");
});

test("moments of a replay are equally wide", () => {
  assert.equal(formatTime(3, 20), "\u20073.00");
  assert.equal(formatTime(13, 20), "13.00");
});

test("dates lose their seconds; what is no date stays", () => {
  assert.equal(formatDate("2026-01-31T12:30:59Z"), "2026-01-31 12:30 UTC");
  assert.equal(formatDate("yesterday"), "yesterday");
  assert.equal(formatDate(undefined), "");
});

test("an agent is put into words, a type without words by its name", () => {
  const modules = {
    environment: { type: "RobotEnvironment" },
    state: { type: "DofState", dof: "5" },
    action_space: { type: "Dcob", target: "angles" },
    features: { type: "NgNet", net: "bq01" },
    learner: { type: "Sarsa" },
  };
  assert.equal(
    agentInWords(modules),
    "Sarsa · DCOB-Q · Gaussian network bq01 · DoF configuration 5",
  );
  assert.equal(
    agentInWords({
      learner: { type: "MotionSearch" },
      action_space: { type: "MotionPlayer", kind: "one_shot", dof: "all" },
    }),
    "motion search (CMA-ES) · motions done once of all joints",
  );
  assert.equal(agentInWords({}), "");
});
