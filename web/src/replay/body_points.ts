// Points of a posed body: its center of mass, and where its links touch what they stand on.

import { Quaternion, Vector3 } from "three";

import type { BodyLink } from "../data/report_data.ts";
import { kPoseSize } from "./motion.ts";

/** Of the links at these poses ([link][7]); nothing where their masses are not known. */
export function centerOfMass(body: BodyLink[], poses: Float32Array): Vector3 | undefined {
  const center = new Vector3();
  let mass = 0;
  for (const [i, link] of body.entries()) {
    if (link.thing) continue;
    if (link.mass === undefined) return undefined;
    const [x = 0, y = 0, z = 0] = poses.subarray(i * kPoseSize);
    center.addScaledVector(new Vector3(x, y, z), link.mass);
    mass += link.mass;
  }
  return mass > 0 ? center.divideScalar(mass) : undefined;
}

export const massOf = (body: BodyLink[]): number =>
  body.reduce((sum, { mass, thing }) => sum + (thing ? 0 : (mass ?? 0)), 0);

const along = (axis: number, length: number): Vector3 =>
  new Vector3().setComponent(axis, length);

const kFlat = 0.02; // the sine of an angle: what is that level lies flat

/** Which end of a shape lies in a direction, by its component; 0, the middle, of one that is level. */
const endToward = (component: number): number =>
  Math.abs(component) < kFlat ? 0 : Math.sign(component);

/**
 * The point of the shape that lies farthest in `direction` (of length 1), both in the shape's own
 * frame; of an edge or a side that lies flat, its middle.
 */
function support(link: BodyLink, direction: Vector3): Vector3 {
  const { shape, size, radius, length, axis, points = [] } = link;
  const end = (half: number): Vector3 => along(axis, half * endToward(direction.getComponent(axis)));
  switch (shape) {
    case "sphere":
      return direction.clone().setLength(radius);
    case "capsule":
      return end(Math.max(0, length / 2 - radius)).add(direction.clone().setLength(radius));
    case "cylinder": {
      const aside = direction.clone().setComponent(axis, 0);
      return aside.length() < kFlat ? end(length / 2) : end(length / 2).add(aside.setLength(radius));
    }
    case "box": {
      const ends = direction.toArray().map(endToward);
      return new Vector3(...ends).multiply(new Vector3(...size)).divideScalar(2);
    }
    case "convex": {
      const far = points.map((point) => new Vector3(...point));
      return far.reduce(
        (best, point) => (point.dot(direction) > best.dot(direction) ? point : best),
        far[0] ?? new Vector3(),
      );
    }
  }
}

/** Where a link at its pose reaches farthest against `normal`, which points away from the ground. */
export function lowestPoint(link: BodyLink, pose: Float32Array, normal: Vector3): Vector3 {
  const [x = 0, y = 0, z = 0, qw = 1, qx = 0, qy = 0, qz = 0] = pose;
  const turn = new Quaternion(qx, qy, qz, qw);
  const [sw, sx, sy, sz] = link.orientation ?? [1, 0, 0, 0];
  const shapeTurn = turn.clone().multiply(new Quaternion(sx, sy, sz, sw));
  const down = normal.clone().negate().applyQuaternion(shapeTurn.clone().invert());
  const middle = new Vector3(...(link.position ?? [0, 0, 0])).applyQuaternion(turn);
  return support(link, down).applyQuaternion(shapeTurn).add(middle).add(new Vector3(x, y, z));
}
