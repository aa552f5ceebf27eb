// Joint angles, from the poses of the links that the joints join.

import type { BodyLink, Joint } from "../data/report_data.ts";
import { formatNumber } from "../data/words.ts";
import { frameAt, kPoseSize, linkCount, type Motion } from "./motion.ts";

type Vector = [number, number, number];
type Quaternion = [number, number, number, number]; // w, x, y, z

const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** `v`, turned by the inverse of `q`. */
function turnBack([w, x, y, z]: Quaternion, v: Vector): Vector {
  const axis: Vector = [-x, -y, -z];
  const once = cross(axis, v);
  const twice = cross(axis, once);
  return [0, 1, 2].map((i) => v[i]! + 2 * (w * once[i]! + twice[i]!)) as Vector;
}

function poseOf(poses: Float32Array, link: number): { place: Vector; turn: Quaternion } {
  const [x = 0, y = 0, z = 0, qw = 1, qx = 0, qy = 0, qz = 0] = poses.subarray(link * kPoseSize);
  return { place: [x, y, z], turn: [qw, qx, qy, qz] };
}

/** From -π to π: how often a joint went round is not in the poses. */
const wrapped = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));

/**
 * Of the joint on which link number `child` hangs [rad]; a positive angle turns the child by minus
 * that about the axis. `poses`: of all links at one time, [link][7].
 */
export function jointAngle({ kind, parent, axis, radius, offset }: Joint, child: number, poses: Float32Array): number {
  const from = poseOf(poses, parent);
  const to = poseOf(poses, child);
  if (kind === "slider") {
    const apart = [0, 1, 2].map((i) => to.place[i]! - from.place[i]!) as Vector;
    const moved = dot(turnBack(from.turn, apart), axis) - dot(offset ?? [0, 0, 0], axis);
    return moved / (radius ?? 1);
  }
  const [pw, ...p] = from.turn;
  const [cw, ...c] = to.turn;
  const between = cross(p, c);
  const turned = [0, 1, 2].map((i) => pw * c[i]! - cw * p[i]! - between[i]!) as Vector;
  return wrapped(-2 * Math.atan2(dot(turned, axis), pw * cw + dot(p, c)));
}

export interface HangingJoint extends Joint {
  child: number; // index of the link
}

/** What the link hangs on, and what hangs on it. */
export const jointsOf = (body: BodyLink[], link: number): HangingJoint[] =>
  body.flatMap(({ joint }, child) =>
    joint && (child === link || joint.parent === link) ? [{ ...joint, child }] : [],
  );

/** The joint's angle at each of `times` [s]. */
export function angleTrace(joint: HangingJoint, motion: Motion, times: Float64Array): Float64Array {
  const size = linkCount(motion) * kPoseSize;
  return times.map((time) => {
    const frame = frameAt(motion, time);
    return jointAngle(joint, joint.child, motion.poses.subarray(frame * size, (frame + 1) * size));
  });
}

const degrees = (angle: number): string => `${formatNumber((180 * angle) / Math.PI)}°`;

/** "left_elbow 0.524 rad, 30.0° (−5.000° … 120.0°)", a line for each joint of the link. */
export function jointsInWords(
  body: BodyLink[],
  link: number,
  poses: Float32Array,
  torques = new Map<string, number>(), // of those joints of which it is known [N m]
): string {
  const lines = jointsOf(body, link).map((joint) => {
    const angle = jointAngle(joint, joint.child, poses);
    const stops = joint.stops ? ` (${joint.stops.map(degrees).join(" … ")})` : "";
    const torque = torques.get(joint.name);
    const words = [`${joint.name}  ${formatNumber(angle)} rad, ${degrees(angle)}${stops}`];
    if (torque !== undefined) words.push(`${formatNumber(torque)} N m`);
    return words.join("  ");
  });
  return lines.join("\n");
}
