import assert from "node:assert/strict";
import { test } from "node:test";

import type { Change, Report } from "../src/data/report_data.ts";
import { GrowingRecord, type EpisodeEvent } from "../src/live/growing_record.ts";

const report = {
  episode: Float32Array.of(1, 2),
  returns: Float32Array.of(10, 20),
  changes: [],
  terms: [{ name: "forward", unit: "", doc: "", values: Float32Array.of(1, 2) }],
  metrics: [],
  learner: [],
  shadows: [],
} as unknown as Report;

const event = (episode: number, more: Partial<EpisodeEvent> = {}): EpisodeEvent => ({
  episode,
  task: "crawling",
  return: 10 * episode,
  end: { kind: "truncated", reason: "time is up" },
  terms: { forward: episode },
  metrics: {},
  learner: {},
  wall_seconds: 2,
  simulated_seconds: 20,
  ...more,
});

const valuesOf = (record: GrowingRecord, name: string): number[] =>
  record.curves.find((curve) => curve.name === name)?.values ?? [];

test("each episode adds to all curves", () => {
  const record = new GrowingRecord(report);
  record.add(event(3), undefined);
  assert.deepEqual(record.episodes, [1, 2, 3]);
  assert.deepEqual(record.returns, [10, 20, 30]);
  assert.deepEqual(valuesOf(record, "forward"), [1, 2, 3]);
  assert.equal(record.lastEnd, "truncated: time is up");
  assert.equal(record.secondsFor(10), 20);
});

test("what is new has nothing before, and what is gone nothing after", () => {
  const record = new GrowingRecord(report);
  record.add(event(3, { terms: { fall: -4 }, shadows: { edited: { task: "crawling", return: 7 } } }), undefined);
  assert.deepEqual(valuesOf(record, "forward"), [1, 2, NaN]);
  assert.deepEqual(valuesOf(record, "fall"), [NaN, NaN, -4]);
  assert.deepEqual(valuesOf(record, "edited"), [NaN, NaN, 7]);
});

test("a trainer that has gone back to a checkpoint repeats episodes", () => {
  const record = new GrowingRecord(report);
  record.add(event(3), undefined);
  record.add(event(2, { return: 5 }), undefined);
  assert.deepEqual(record.episodes, [1, 2]);
  assert.deepEqual(record.returns, [10, 5]);
  assert.deepEqual(valuesOf(record, "forward"), [1, 2]);
});

test("a record that is read again takes the place of what was known", () => {
  const record = new GrowingRecord(report);
  record.add(event(3, { terms: { fall: -4 } }), undefined);
  const fall = record.curves.find((curve) => curve.name === "fall");
  record.read(report);
  assert.deepEqual(record.episodes, [1, 2]);
  assert.deepEqual(valuesOf(record, "forward"), [1, 2]);
  assert.deepEqual(fall?.values, [NaN, NaN]);
});

test("what a change made of the task is learned after the change", () => {
  const record = new GrowingRecord(report);
  const change = { episode: 3, step: 40, kind: "swap", text: "swap task: b.task" } as Change;
  record.changes.push(change, { ...change, text: "set task.weight = 2" });
  assert.ok(!record.takeDifferences([change]));
  const told = { ...change, at: "2026-01-02T03:04:05Z", difference: "param weight: removed\n" };
  assert.ok(!record.takeDifferences([{ ...told, step: 41 }]));
  assert.ok(record.takeDifferences([told]));
  assert.deepEqual(record.changes.map(({ difference }) => difference), ["param weight: removed\n", undefined]);
  assert.ok(!record.takeDifferences([told]));
});
