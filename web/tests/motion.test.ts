import assert from "node:assert/strict";
import { test } from "node:test";

import {
  durationOf,
  frameAt,
  linkCount,
  sampleMotion,
  smoothPath,
  snapshotTimes,
  type Motion,
} from "../src/replay/motion.ts";
import { sideOf } from "../src/replay/side.ts";

const kHalf = Math.SQRT1_2; // of a quarter turn: cos 45 degrees = sin 45 degrees

const motion = (poses: number[][], interval = 0.5): Motion => ({
  frames: poses.length,
  interval,
  poses: new Float32Array(poses.flat()),
});

function sampled(source: Motion, time: number): number[] {
  const out = new Float32Array(linkCount(source) * 7);
  sampleMotion(source, time, out);
  return [...out].map((value) => Math.round(value * 1e5) / 1e5);
}

const quarterTurn = motion([
  [0, 0, 0.25, 1, 0, 0, 0],
  [1, -2, 0.25, kHalf, 0, 0, kHalf],
]);

test("between two frames the pose is halfway", () => {
  const eighth = Math.round(Math.cos(Math.PI / 8) * 1e5) / 1e5;
  const sine = Math.round(Math.sin(Math.PI / 8) * 1e5) / 1e5;
  assert.deepEqual(sampled(quarterTurn, 0.25), [0.5, -1, 0.25, eighth, 0, 0, sine]);
});

test("the opposite quaternion is the same orientation", () => {
  const flipped = motion([
    [0, 0, 0, 1, 0, 0, 0],
    [0, 0, 0, -1, 0, 0, 0],
  ]);
  assert.deepEqual(sampled(flipped, 0.2), [0, 0, 0, 1, 0, 0, 0]);
});

test("before the start and after the end the first and the last frame stand", () => {
  assert.deepEqual(sampled(quarterTurn, -1).slice(0, 3), [0, 0, 0.25]);
  assert.deepEqual(sampled(quarterTurn, 9).slice(0, 3), [1, -2, 0.25]);
  assert.equal(durationOf(quarterTurn), 0.5);
});

test("a moment on a frame belongs to that frame", () => {
  const tenth = motion(
    Array.from({ length: 31 }, () => [0, 0, 0, 1, 0, 0, 0]),
    0.1,
  );
  assert.equal(frameAt(tenth, 0.3), 3); // 0.3 / 0.1 is a little less than 3
  assert.equal(frameAt(tenth, 0.29), 2);
  assert.equal(frameAt(tenth, 99), 30);
});

test("a straight path is its own mean, and a step becomes a ramp", () => {
  const at = (x: number): number[] => [x, 2 * x, 0, 1, 0, 0, 0];
  assert.deepEqual([...smoothPath(motion([0, 1, 2, 3].map(at), 1), 0, 1)], [0, 0, 1, 2, 2, 4, 3, 6]);
  const step = smoothPath(motion([0, 0, 3, 3].map(at), 1), 0, 1);
  assert.deepEqual([step[0], step[2], step[4], step[6]], [0, 1, 2, 3]);
});

test("snapshots are evenly spaced and stay within the episode", () => {
  assert.deepEqual(snapshotTimes(7, 0, 7, 8), [0, 1, 2, 3, 4, 5, 6, 7]);
  assert.deepEqual(snapshotTimes(7, 2, 2, 3), [2, 3, 4]);
  assert.deepEqual(snapshotTimes(7, 6, 2, 3), [5, 6, 7]);
  assert.deepEqual(snapshotTimes(1, 0, 4, 2), [0, 1]);
});

test("sides are told by whole words of the links' names", () => {
  assert.equal(sideOf("left_upper_arm"), "left");
  assert.equal(sideOf("foot_right"), "right");
  assert.equal(sideOf("body"), "trunk");
  assert.equal(sideOf("cleft"), "trunk");
});
