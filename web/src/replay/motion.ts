// Poses between the recorded frames.

import type { Recording } from "../data/report_data.ts";
import { endOf } from "../data/timeline.ts";

export const kPoseSize = 7; // x, y, z, then the quaternion w, x, y, z

export type Motion = Pick<Recording, "frames" | "interval" | "poses" | "timeline"> &
  Partial<Pick<Recording, "goals">>;

/** A recorded episode, whatever else is known of it. */
export type Replay = Motion & Pick<Recording, "episode">;

/** From the first frame to the last one, or to the end of the episode where that is known [s]. */
export function durationOf(motion: Motion): number {
  const frames = Math.max(0, motion.frames - 1) * motion.interval;
  return motion.timeline ? Math.max(frames, endOf(motion.timeline)) : frames;
}

/** The number of links, from the size of a frame. */
export const linkCount = (motion: Motion): number =>
  motion.frames > 0 ? motion.poses.length / (motion.frames * kPoseSize) : 0;

/** The index of the last frame not after `time` [s]. */
export function frameAt(motion: Motion, time: number): number {
  const frame = Math.floor(time / motion.interval + 1e-6);
  return Math.min(Math.max(frame, 0), motion.frames - 1);
}

/**
 * Writes the pose of each link at `time` [s] to `out` ([link][7]): positions in between linearly,
 * orientations along the shorter arc (linearly and normalized: frames are close to each other).
 */
export function sampleMotion(motion: Motion, time: number, out: Float32Array): void {
  const first = frameAt(motion, time);
  const second = Math.min(first + 1, motion.frames - 1);
  const weight = Math.min(Math.max(time / motion.interval - first, 0), 1);
  const size = out.length;
  for (let offset = 0; offset < size; offset += kPoseSize) {
    const a = motion.poses.subarray(first * size + offset, first * size + offset + kPoseSize);
    const b = motion.poses.subarray(second * size + offset, second * size + offset + kPoseSize);
    blendPoses(a, b, weight, out.subarray(offset, offset + kPoseSize));
  }
}

function blendPoses(a: Float32Array, b: Float32Array, weight: number, out: Float32Array): void {
  const at = (values: Float32Array, i: number): number => values[i] as number;
  let dot = 0;
  for (let i = 3; i < kPoseSize; ++i) dot += at(a, i) * at(b, i);
  const sign = dot < 0 ? -1 : 1; // q and -q are the same orientation
  let norm = 0;
  for (let i = 0; i < kPoseSize; ++i) {
    const second = i < 3 ? at(b, i) : sign * at(b, i);
    out[i] = (1 - weight) * at(a, i) + weight * second;
    if (i >= 3) norm += at(out, i) ** 2;
  }
  for (let i = 3; i < kPoseSize; ++i) out[i] = at(out, i) / Math.sqrt(norm);
}

/** A link's path over the ground ([frame][x, y]), each point the mean of `halfWidth` s around. */
export function smoothPath(motion: Motion, link: number, halfWidth: number): Float32Array {
  const stride = linkCount(motion) * kPoseSize;
  const first = link * kPoseSize;
  const half = Math.max(0, Math.round(halfWidth / motion.interval));
  const path = new Float32Array(2 * motion.frames);
  for (let frame = 0; frame < motion.frames; ++frame) {
    // The window shrinks toward both ends, so that the path starts and ends where the link does.
    const reach = Math.min(half, frame, motion.frames - 1 - frame);
    for (let i = frame - reach; i <= frame + reach; ++i) {
      path[2 * frame]! += (motion.poses[i * stride + first] as number) / (2 * reach + 1);
      path[2 * frame + 1]! += (motion.poses[i * stride + first + 1] as number) / (2 * reach + 1);
    }
  }
  return path;
}

/** Where the path leads at `time` [s], between its frames: x, y [m]. */
export function placeOnPath(path: Float32Array, motion: Motion, time: number): [number, number] {
  const frame = motion.frames > 0 ? frameAt(motion, time) : 0;
  const next = Math.min(frame + 1, motion.frames - 1);
  const weight = Math.min(Math.max(time / motion.interval - frame, 0), 1);
  const between = (i: number): number =>
    (1 - weight) * (path[2 * frame + i] ?? 0) + weight * (path[2 * next + i] ?? 0);
  return [between(0), between(1)];
}

/** `count` moments [s] with equal spaces, from `start` on, that span at most `span` seconds. */
export function snapshotTimes(
  duration: number,
  start: number,
  span: number,
  count: number,
): number[] {
  const length = Math.min(span, duration);
  const from = Math.min(Math.max(start, 0), duration - length);
  return Array.from({ length: count }, (_, i) => from + (length * i) / Math.max(1, count - 1));
}
