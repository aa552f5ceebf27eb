import assert from "node:assert/strict";
import { test } from "node:test";

import type { BodyLink } from "../src/data/report_data.ts";
import { framingOf, subjectOf } from "../src/replay/framing.ts";
import { spacingFor } from "../src/replay/ground.ts";
import type { Motion } from "../src/replay/motion.ts";

const ball = (name: string, radius: number): BodyLink => ({
  name,
  shape: "sphere",
  size: [0, 0, 0],
  radius,
  length: 0,
  axis: 2,
});

/** Poses of all links in each frame: x, y, z and the angle about y. */
const motionOf = (frames: [number, number, number, number][][]): Motion => ({
  frames: frames.length,
  interval: 0.02,
  poses: new Float32Array(
    frames.flat().flatMap(([x, y, z, angle]) => [
      ...[x, y, z, Math.cos(angle / 2)],
      ...[0, Math.sin(angle / 2), 0],
    ]),
  ),
});

const body = [ball("rail", 0.1), ball("carriage", 0.1), ball("torso", 0.1), ball("foot", 0.1)];
const led = (legHeight: number, baseSpeed = 0): Motion =>
  motionOf(
    Array.from({ length: 101 }, (_, i) => [
      [baseSpeed * i, 0, 3, 0],
      [0.02 * i, 0, 2.85, 0],
      [0.02 * i, 0, legHeight, 0],
      [0.02 * i, 0, legHeight - 0.15, 0.01 * i],
    ]),
  );

test("a replay is about the whole robot that moves freely", () => {
  assert.deepEqual(subjectOf(body, led(1, 0.02)), [0, 1, 2, 3]);
});

test("of a robot with a fixed base it is about what turns and what touches that", () => {
  assert.deepEqual(subjectOf(body, led(1)), [2, 3]);
  assert.deepEqual(subjectOf(body, led(2.7)), [0, 1, 2, 3]);
});

test("the camera follows it at its height, and as far away as it is large", () => {
  const { anchor, height, radius } = framingOf(body, led(0.4));
  assert.equal(anchor, 2);
  assert.ok(Math.abs(height - 0.325) < 1e-6);
  assert.ok(Math.abs(radius - 0.175) < 1e-6);
});

test("the floor's lines suit the robot", () => {
  assert.deepEqual([0.05, 0.2, 0.5, 100].map(spacingFor), [0.1, 0.5, 1, 10]);
});
