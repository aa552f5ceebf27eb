import assert from "node:assert/strict";
import { test } from "node:test";

import { rewardLines } from "../src/data/task_source.ts";
import {
  decodeTimeline,
  endOf,
  sampleAt,
  tellingTime,
  touches,
  type Timeline,
} from "../src/data/timeline.ts";
import { fragmentOf, momentIn } from "../src/replay/link.ts";
import { durationOf } from "../src/replay/motion.ts";
import { columnsOf, extremesOf, ticksOf } from "../src/timeline/trace.ts";

const floats = (...values: number[]): string =>
  Buffer.from(new Float32Array(values).buffer).toString("base64");

/** Of three frames, 20 ms apart. */
const encoded = (end: number) => ({
  end,
  returns: floats(0, 1, 2, -4),
  terms: [{ name: "fall", doc: "", values: floats(0, 0, 0, -4) }],
  metrics: [{ name: "way", unit: "m", reduction: "last", doc: "", values: floats(NaN, 1, 2, 3) }],
  phases: { names: ["reach", "lift"], values: floats(0, 0, 1, 1) },
  contacts: Buffer.from([0, 0, 3, 0, 128, 1, 0, 2]).toString("base64"),
});

const decoded = (end = 0.055): Timeline =>
  decodeTimeline(encoded(end), { frames: 3, interval: 0.02 }) as Timeline;

test("what was paid is added up to the end of the episode", () => {
  const { total, terms, times, metrics, phases } = decoded();
  assert.deepEqual([...times], [0, 0.02, 0.04, 0.055]);
  assert.deepEqual([...total.sum], [0, 1, 3, -1]);
  assert.deepEqual([...(terms[0]?.sum ?? [])], [0, 0, 0, -4]);
  assert.deepEqual([...(metrics[0]?.values ?? [])], [NaN, 1, 2, 3]);
  assert.deepEqual([...(phases?.values ?? [])], [0, 0, 1, 1]);
  assert.equal(endOf(decoded()), 0.055);
});

test("an episode that ends with its last frame has one sample there", () => {
  const { total, times, metrics } = decoded(0.04);
  assert.deepEqual([...times], [0, 0.02, 0.04]);
  assert.deepEqual([...total.paid], [0, 1, -2]);
  assert.equal(metrics[0]?.values[2], 3);
});

test("a recording without a timeline has none", () => {
  assert.equal(decodeTimeline(null, { frames: 3, interval: 0.02 }), undefined);
});

test("a moment shows the last sample before it", () => {
  const at = [0, 0.019, 0.02, 0.041, 0.0549, 0.055, 9].map((time) => sampleAt(decoded(), time));
  assert.deepEqual(at, [0, 0, 1, 2, 2, 3, 3]);
});

test("links touch by their bits", () => {
  const links = (sample: number): number[] =>
    Array.from({ length: 16 }, (_, i) => i).filter((link) => touches(decoded(), 16, sample, link));
  assert.deepEqual([0, 1, 2, 3].map(links), [[], [0, 1], [7, 8], [9]]);
});

test("a replay lasts to the end of its episode", () => {
  const motion = { frames: 3, interval: 0.02, poses: new Float32Array(21) };
  assert.equal(durationOf(motion), 0.04);
  assert.equal(durationOf({ ...motion, timeline: decoded() }), 0.055);
});

test("a replay opens where most is paid, away from both ends", () => {
  const paid = Array.from({ length: 101 }, (_, i) => (i === 2 ? 99 : i > 60 && i <= 70 ? 1 : 0));
  const timeline = decodeTimeline(
    { ...encoded(2), returns: floats(...paid, 0), terms: [], metrics: [], contacts: "" },
    { frames: 101, interval: 0.02 },
  ) as Timeline;
  const time = tellingTime(timeline);
  assert.ok(time >= 1.2 && time <= 1.42, String(time));
});

test("lines that pay are found, but for those in comments and those that are overridden", () => {
  const own = "override reward rate roll = 2\nif x { reward fall = -4 } // reward no = 1\nreward == 3";
  const base = "reward rate roll = 1\nreward potential near = -d\n  reward rate = 5";
  assert.deepEqual(rewardLines([own, base]), [
    { source: 0, line: 0, term: "roll" },
    { source: 0, line: 1, term: "fall" },
    { source: 1, line: 1, term: "near" },
    { source: 1, line: 2, term: "rate" },
  ]);
});

test("a link leads to an episode and a moment", () => {
  assert.equal(fragmentOf({ episode: 120, time: 3.40000001 }), "#episode=120&t=3.4");
  assert.deepEqual(momentIn("#episode=120&t=3.4"), { episode: 120, time: 3.4 });
  assert.deepEqual(momentIn("#episode=7"), { episode: 7, time: 0 });
  assert.equal(momentIn("#curve-heading"), undefined);
  assert.equal(momentIn(""), undefined);
});

test("a trace has the least and the greatest value of each pixel", () => {
  const data = {
    times: Float64Array.from([0, 0.1, 0.2, 1]),
    values: Float64Array.from([1, -2, NaN, 3]),
    duration: 1,
  };
  const columns = columnsOf(data, 4);
  assert.deepEqual(columns[0], { low: -2, high: 1 });
  assert.deepEqual(columns[1], { low: NaN, high: NaN });
  assert.deepEqual(columns[3], { low: 3, high: 3 });
  assert.deepEqual(extremesOf(data, true), { low: -2, high: 3 });
  const none = { ...data, values: Float64Array.from([NaN]) };
  assert.deepEqual(extremesOf(none, false), { low: 0, high: 0 });
  const beside = Float64Array.from([7, NaN]);
  assert.deepEqual(extremesOf({ ...none, beside }, false), { low: 7, high: 7 });
});

test("the time axis has round marks", () => {
  assert.deepEqual(ticksOf(5, 360), [0, 1, 2, 3, 4, 5]);
  assert.deepEqual(ticksOf(20.005, 300), [0, 5, 10, 15, 20]);
});
