// Frames as the server sends them, for tests of what is made of them.

import { decodeClip, decodeLayout, Frame, type Layout } from "../src/live/view_frames.ts";

/** A value of a layout; `more`: what else is said of it. */
export const value = (kind: string, name: string, type: string, more: object = {}): { size: number } => ({
  ...{ kind, name, type, unit: "", doc: "", size: 1 },
  ...more,
});

/** Of a task without links, so that a frame holds its time, return and actions, and these values. */
export function layoutOf(values: { size: number }[]): Layout {
  const size = values.reduce((sum, each) => sum + each.size, 3);
  const head = { module: "task", task: "crawling", hash: "a1", links: 0, poses: 0 };
  return decodeLayout(JSON.stringify({ ...head, size, values }));
}

export function frameOf(layout: Layout, numbers: number[]): Frame {
  const bytes = new ArrayBuffer(7 * 8 + numbers.length * 4);
  new Float64Array(bytes, 0, 7).set([1, 5, 12, 1, 0.1, 1, 0.01]);
  new Float32Array(bytes, 7 * 8).set(numbers);
  return new Frame(decodeClip(layout, bytes), 0);
}
