import assert from "node:assert/strict";
import { test } from "node:test";

import { Vector3 } from "three";

import type { BodyLink } from "../src/data/report_data.ts";
import { centerOfMass, lowestPoint, massOf } from "../src/replay/body_points.ts";

const kUp = new Vector3(0, 0, 1);
const kTurnedAboutY = [Math.SQRT1_2, 0, Math.SQRT1_2, 0]; // by a quarter: x to -z, z to x

const link = (more: Partial<BodyLink>): BodyLink => ({
  name: "link",
  shape: "sphere",
  size: [0, 0, 0],
  radius: 0.1,
  length: 0,
  axis: 2,
  ...more,
});
const pose = (x: number, y: number, z: number, turn = [1, 0, 0, 0]): Float32Array =>
  new Float32Array([x, y, z, ...turn]);
const about = ({ x, y, z }: Vector3): number[] =>
  [x, y, z].map((value) => Math.round(1e4 * value) / 1e4 + 0);

test("the center of mass is the mean of the links' centers by their masses", () => {
  const body = [link({ mass: 3 }), link({ mass: 1 }), link({ thing: true })];
  const poses = new Float32Array([...pose(0, 0, 1), ...pose(4, 0, 2), ...pose(9, 9, 9)]);
  assert.deepEqual(about(centerOfMass(body, poses) as Vector3), [1, 0, 1.25]);
  assert.equal(massOf(body), 4);
  assert.equal(centerOfMass([link({})], pose(0, 0, 1)), undefined); // of an older run
});

test("the lowest point of each shape", () => {
  const at = (more: Partial<BodyLink>, turn?: number[], up = kUp): number[] =>
    about(lowestPoint(link(more), pose(1, 2, 3, turn), up));
  assert.deepEqual(at({}), [1, 2, 2.9]);
  const capsule: Partial<BodyLink> = { shape: "capsule", length: 0.6, axis: 2 };
  assert.deepEqual(at(capsule), [1, 2, 2.7]);
  assert.deepEqual(at(capsule, kTurnedAboutY), [1, 2, 2.9]); // lies flat
  const box: Partial<BodyLink> = { shape: "box", size: [0.4, 0.2, 1] };
  assert.deepEqual(at(box), [1, 2, 2.5]);
  assert.deepEqual(at(box, kTurnedAboutY), [1, 2, 2.8]);
  const cylinder: Partial<BodyLink> = { shape: "cylinder", length: 0.6, axis: 2 };
  assert.deepEqual(at(cylinder), [1, 2, 2.7]);
  assert.deepEqual(at(cylinder, kTurnedAboutY), [1, 2, 2.9]);
  const wedge: Partial<BodyLink> = { shape: "convex", points: [[0, 0, 0.5], [0.5, 0, 0], [0, 0, -0.2]] };
  assert.deepEqual(at(wedge), [1, 2, 2.8]);
  assert.deepEqual(at(wedge, kTurnedAboutY), [1, 2, 2.5]);
});

test("a shape beside its link's center, and a ground that is not level", () => {
  const moved = link({ position: [0, 0, -0.5] });
  assert.deepEqual(about(lowestPoint(moved, pose(0, 0, 1), kUp)), [0, 0, 0.4]);
  assert.deepEqual(about(lowestPoint(moved, pose(0, 0, 1, kTurnedAboutY), kUp)), [-0.5, 0, 0.9]);
  const slope = new Vector3(0.6, 0, 0.8);
  assert.deepEqual(about(lowestPoint(link({}), pose(0, 0, 1), slope)), [-0.06, 0, 0.92]);
});
