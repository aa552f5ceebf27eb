// What of a robot the replay is about, and how large that is: the camera, the light, the fog and the
// floor are as large as the robot needs them.

import type { BodyLink } from "../data/report_data.ts";
import { kPoseSize, linkCount, type Motion } from "./motion.ts";

const kMostFramesRead = 200;
const kStill = 1e-4; // less is no way [m]
const kStraight = 1e-3; // less is no turn: of the elements of a quaternion

export interface Framing {
  anchor: number; // index of the link that is followed
  height: number; // of the point that the camera looks at, above the ground [m]
  radius: number; // around that point, of what is to be seen [m]
}

type Vector = [number, number, number];

const valueAt = (motion: Motion, frame: number, link: number, i: number): number =>
  motion.poses[(frame * linkCount(motion) + link) * kPoseSize + i] as number;

const placeOf = (motion: Motion, frame: number, link: number): Vector => [
  valueAt(motion, frame, link, 0),
  valueAt(motion, frame, link, 1),
  valueAt(motion, frame, link, 2),
];

const distance = (a: Vector, b: Vector): number =>
  Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/** Of the smallest ball around the link's center that holds its shape. */
function radiusOf({ shape, size, radius, length, position, points = [] }: BodyLink): number {
  const aside = position ? Math.hypot(...position) : 0;
  if (shape === "convex") return aside + Math.max(0, ...points.map((point) => Math.hypot(...point)));
  if (shape === "box") return aside + Math.hypot(...size) / 2;
  if (shape === "cylinder") return aside + Math.hypot(radius, length / 2);
  return aside + (shape === "capsule" ? Math.max(radius, length / 2) : radius);
}

/** Some frames, evenly spread, the first and the last one included. */
function someFrames({ frames }: Motion): number[] {
  const count = Math.min(frames, kMostFramesRead);
  return Array.from({ length: count }, (_, i) =>
    Math.round((i * (frames - 1)) / Math.max(1, count - 1)),
  );
}

/** Whether one of the elements `first` to `last` of the link's pose differs from the first frame's. */
const changes = (motion: Motion, link: number, first: number, last: number, by: number): boolean =>
  someFrames(motion).some((frame) => {
    for (let i = first; i <= last; ++i) {
      if (Math.abs(valueAt(motion, frame, link, i) - valueAt(motion, 0, link, i)) > by) return true;
    }
    return false;
  });

/**
 * Indices of the links that are looked at, in their order: mostly all. Where the base stays where it
 * is, only those that turn, and what hangs together with them: as in the pictures of
 * runtime/analysis/picture/subject.h.
 */
export function subjectOf(body: BodyLink[], motion: Motion): number[] {
  const all = body.map((_, i) => i);
  if (changes(motion, 0, 0, 2, kStill) || changes(motion, 0, 3, 6, kStraight)) return all;
  const subject = all.filter((link) => changes(motion, link, 3, 6, kStraight));
  if (subject.length === 0) return all;
  const radius = body.map(radiusOf);
  for (const link of subject) {
    const touching = all.filter(
      (other) =>
        !subject.includes(other) &&
        distance(placeOf(motion, 0, link), placeOf(motion, 0, other)) <=
          (radius[link] as number) + (radius[other] as number),
    );
    subject.push(...touching); // and is come to in its turn
  }
  return subject.sort((a, b) => a - b);
}

const median = (values: number[]): number =>
  values.sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? 0;

/** Of a motion with at least one frame. `groundAt`: how high the ground is [m]. */
export function framingOf(
  body: BodyLink[],
  motion: Motion,
  groundAt: (x: number, y: number) => number = () => 0,
): Framing {
  const subject = subjectOf(body, motion);
  const anchor = subject[0] ?? 0;
  const radius = body.map(radiusOf);
  const frames = someFrames(motion);
  const groundBelow = (frame: number): number => {
    const [x, y] = placeOf(motion, frame, anchor);
    return groundAt(x, y);
  };
  const middle = (frame: number): number =>
    subject.reduce((sum, link) => sum + valueAt(motion, frame, link, 2), 0) / subject.length -
    groundBelow(frame);
  const height = Math.max(0, median(frames.map(middle)));
  const reach = (frame: number): number => {
    const [x, y] = placeOf(motion, frame, anchor);
    const middleNow: Vector = [x, y, height + groundBelow(frame)];
    return Math.max(
      ...subject.map(
        (link) => distance(placeOf(motion, frame, link), middleNow) + (radius[link] as number),
      ),
    );
  };
  return { anchor, height, radius: median(frames.map(reach)) };
}
