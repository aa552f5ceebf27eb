import assert from "node:assert/strict";
import { test } from "node:test";

import type { BodyLink, Joint } from "../src/data/report_data.ts";
import { angleTrace, jointAngle, jointsInWords, jointsOf } from "../src/replay/joints.ts";

const kAbout = 1e-6;

const link = (name: string, joint?: Joint): BodyLink => ({
  name,
  shape: "sphere",
  size: [0, 0, 0],
  radius: 0.1,
  length: 0,
  axis: 2,
  ...(joint && { joint }),
});
const elbow: Joint = { name: "elbow", kind: "hinge", parent: 0, axis: [0, 1, 0], stops: [-1, 2] };
const wrist: Joint = { name: "wrist", kind: "continuous", parent: 1, axis: [1, 0, 0] };

/** A pose at the origin, turned about y by `angle`. */
const turned = (angle: number): number[] => [0, 0, 0, Math.cos(angle / 2), 0, Math.sin(angle / 2), 0];

test("a positive angle turns the child by minus that about the axis", () => {
  const poses = new Float32Array([...turned(0.4), ...turned(0.4 - 0.7)]);
  assert.ok(Math.abs(jointAngle(elbow, 1, poses) - 0.7) < kAbout);
});

test("q and -q are the same orientation", () => {
  const child = turned(-0.7).map((value, i) => (i < 3 ? value : -value));
  const poses = new Float32Array([...turned(0), ...child]);
  assert.ok(Math.abs(jointAngle(elbow, 1, poses) - 0.7) < kAbout);
});

test("a slider's angle is that of its pinion", () => {
  const slider: Joint = {
    ...elbow,
    kind: "slider",
    axis: [1, 0, 0],
    radius: 0.05,
    offset: [0.2, 0, 0.1],
  };
  // The parent is turned by a quarter about y: its x points down.
  const quarter = turned(Math.PI / 2);
  const poses = new Float32Array([...quarter, 0.1, 0, -0.3, ...quarter.slice(3)]);
  assert.ok(Math.abs(jointAngle(slider, 1, poses) - (0.3 - 0.2) / 0.05) < 1e-5);
});

test("a link has the joint that it hangs on and those that hang on it", () => {
  const body = [link("trunk"), link("arm", elbow), link("hand", wrist)];
  assert.deepEqual(jointsOf(body, 0).map(({ name }) => name), ["elbow"]);
  assert.deepEqual(jointsOf(body, 1).map(({ name, child }) => [name, child]), [["elbow", 1], ["wrist", 2]]);
  assert.deepEqual(jointsOf([link("trunk")], 0), []);
  const poses = new Float32Array([...turned(0), ...turned(-0.5), ...turned(-0.5)]);
  const torques = new Map([["elbow", -1.25]]);
  assert.equal(
    jointsInWords(body, 1, poses, torques),
    "elbow  0.500 rad, 28.65° (−57.30° … 114.6°)  −1.250 N m\nwrist  0.000 rad, 0.000°",
  );
});

test("the trace has the angle of the frame at each sample", () => {
  const poses = new Float32Array([...turned(0), ...turned(0), ...turned(0), ...turned(-1)]);
  const trace = angleTrace({ ...elbow, child: 1 }, { frames: 2, interval: 0.5, poses }, Float64Array.from([0, 0.5, 0.7]));
  assert.deepEqual([...trace].map((angle) => Math.round(1e5 * angle) / 1e5 + 0), [0, 1, 1]);
});
