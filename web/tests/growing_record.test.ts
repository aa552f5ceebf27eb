import assert from "node:assert/strict";
import { test } from "node:test";

import type { Change, Report } from "../src/data/report_data.ts";
import { GrowingRecord, type EpisodeEvent } from "../src/live/growing_record.ts";

const report = {
  episode: Float32Array.of(1, 2),
  returns: Float32Array.of(10, 20),
  changes: [],
  ends: [{ kind: "truncated", reason: "time is up", count: 2 }],
  endOf: [0, 0],
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

test("however many episodes, there are so many rows at most, each a mean", () => {
  const record = new GrowingRecord(report, 4);
  for (let i = 3; i <= 9; ++i) record.add(event(i), undefined);
  // 1..8 in rows of two, then halved once more with what the ninth brought.
  assert.equal(record.episodesPerRow, 4);
  assert.deepEqual(record.episodes, [4, 8, 9]);
  assert.deepEqual(record.returns, [25, 65, 90]);
  assert.deepEqual(valuesOf(record, "forward"), [2.5, 6.5, 9]);
  assert.deepEqual(record.best, { episode: 9, value: 90 });
  for (let i = 10; i <= 1000; ++i) record.add(event(i), undefined);
  assert.ok(record.episodes.length <= 4);
  assert.equal(record.episodes.at(-1), 1000);
  const mean = record.returns.reduce((sum, value) => sum + value, 0) / record.returns.length;
  assert.ok(mean > 4000 && mean < 6500);
  assert.equal(record.rowsOf(20), 1);
});

test("a long record is halved when it is read", () => {
  const episode = Float32Array.from({ length: 9 }, (_, i) => i + 1);
  const long = { ...report, episode, returns: episode, terms: [], endOf: Array(9).fill(0) };
  const record = new GrowingRecord(long as unknown as Report, 4);
  assert.deepEqual(record.episodes, [4, 8, 9]);
  assert.deepEqual(record.returns, [2.5, 6.5, 9]);
  record.add(event(10), undefined);
  assert.deepEqual(record.episodes, [4, 8, 10]);
  assert.deepEqual(record.returns, [2.5, 6.5, 54.5]);
});

test("a run that went back to a checkpoint is cut there, also within a row", () => {
  const record = new GrowingRecord(report, 4);
  for (let i = 3; i <= 9; ++i) record.add(event(i), undefined);
  record.add(event(6), undefined);
  assert.deepEqual(record.episodes, [4, 6]);
  assert.deepEqual(record.returns, [25, 60]);
});
