import assert from "node:assert/strict";
import { test } from "node:test";

import {
  decodeClip,
  decodeLayout,
  forcesIn,
  Frame,
  goalsIn,
  torquesIn,
  type ViewValue,
} from "../src/live/view_frames.ts";
import { History } from "../src/live/history.ts";

const kLinks = 2;
const kText = JSON.stringify({
  module: "task",
  task: "crawling",
  hash: "a1",
  links: kLinks,
  poses: kLinks,
  size: 3 + 8 * kLinks + 1 + 3,
  values: [
    { kind: "term", name: "forward", type: "real", unit: "", doc: "", size: 1 },
    { kind: "sensor", name: "v", type: "vec3", unit: "m/s", doc: "", size: 3 },
  ],
});

/** As the trainer writes it: frames of time, actions and what the term has paid. */
function bytesOf(isEpisode: boolean, frames: [number, number, number][], size: number): ArrayBuffer {
  const bytes = new ArrayBuffer(7 * 8 + frames.length * size * 4);
  new Float64Array(bytes, 0, 7).set([isEpisode ? 1 : 0, 5, 12, frames.length, 0.1, 1, 0.01]);
  const numbers = new Float32Array(bytes, 7 * 8);
  frames.forEach(([time, actions, paid], i) => {
    numbers.set([time, paid, actions], i * size);
    numbers.set([1, 0], i * size + 3 + 7 * kLinks);
    numbers.set([paid, 0.1, 0.2, 0.3], i * size + 3 + 8 * kLinks);
  });
  return bytes;
}

test("a frame is read as it was written", () => {
  const layout = decodeLayout(kText);
  const clip = decodeClip(layout, bytesOf(true, [[0, 0, 0], [0.1, 1, 2.5]], layout.size));
  assert.equal(clip.isEpisode, true);
  assert.equal(clip.episode, 5);
  assert.equal(clip.steps, 12);
  const frame = new Frame(clip, 1);
  assert.equal(frame.time, Math.fround(0.1));
  assert.equal(frame.return, 2.5);
  assert.equal(frame.actions, 1);
  assert.deepEqual([...frame.contacts], [1, 0]);
  assert.deepEqual([...frame.valuesOf(layout.values[1] as ViewValue)], [0.1, 0.2, 0.3].map(Math.fround));
});

test("forces, torques and goals are those that the task has", () => {
  const parsed = JSON.parse(kText) as { size: number; values: object[] };
  const more = [
    { kind: "goal", name: "target", type: "vec2", unit: "m", doc: "", size: 2 },
    { kind: "sensor", name: "contact_force", type: "vec3[link]", unit: "N", doc: "", size: 6 },
    { kind: "sensor", name: "joint.torque", type: "real[joint]", unit: "N m", doc: "", size: 2 },
  ];
  Object.assign(more[2] as object, { elements: ["joint.torque[hip]", "joint.torque[knee]"] });
  const size = parsed.size + 10;
  const layout = decodeLayout(JSON.stringify({ ...parsed, size, values: [...parsed.values, ...more] }));
  const bytes = bytesOf(true, [[0.5, 0, 0]], size);
  new Float32Array(bytes, 7 * 8).set([1, 2, 0, 0, 9, 3, 4, 5, -0.5, 0.25], parsed.size);
  const frame = new Frame(decodeClip(layout, bytes), 0);
  assert.deepEqual([...(forcesIn(frame) ?? [])], [0, 0, 9, 3, 4, 5]);
  assert.deepEqual([...torquesIn(frame)], [["hip", -0.5], ["knee", 0.25]]);
  const [goal] = goalsIn(frame);
  assert.deepEqual([goal?.name, goal?.time, goal?.value], ["target", 0.5, [1, 2]]);
  const plain = new Frame(decodeClip(decodeLayout(kText), bytesOf(true, [[0, 0, 0]], parsed.size)), 0);
  assert.equal(forcesIn(plain), undefined);
  assert.equal(torquesIn(plain).size, 0);
  assert.deepEqual(goalsIn(plain), []);
});

test("what does not add up is refused", () => {
  const layout = decodeLayout(kText);
  assert.throws(() => decodeLayout(kText.replace('"links":2', '"links":3')));
  assert.throws(() => decodeClip(layout, bytesOf(true, [[0, 0, 0]], layout.size - 1)));
});

test("a term's rate is what it has paid in a third of a second, its action's sum since that began", () => {
  const layout = decodeLayout(kText);
  const frames = Array.from({ length: 8 }, (_, i): [number, number, number] => [
    i / 10,
    i < 4 ? 1 : 2,
    i, // 10 for each second
  ]);
  const clip = decodeClip(layout, bytesOf(true, frames, layout.size));
  const history = new History();
  assert.equal(history.add(new Frame(clip, 0)), true);
  for (let i = 1; i < 8; ++i) assert.equal(history.add(new Frame(clip, i)), false);
  const term = layout.values[0] as ViewValue;
  assert.ok(Math.abs((history.last?.rates.get(term) ?? 0) - 10) < 1e-4);
  assert.equal(history.last?.ofAction.get(term), 7 - 4);
  assert.equal(history.entries[0]?.startsEpisode, true);
  assert.equal(history.entries[1]?.startsEpisode, false);
});

test("who goes back in an episode sees what was before, as if it had just passed", () => {
  const layout = decodeLayout(kText);
  const times = [0, 1, 2, 3, 4, 5].map((i): [number, number, number] => [i / 10, 0, i]);
  const clip = decodeClip(layout, bytesOf(true, times, layout.size));
  const history = new History();
  for (let i = 0; i < 6; ++i) history.add(new Frame(clip, i));
  for (let i = 0; i < 4; ++i) history.add(new Frame(clip, i));
  assert.deepEqual(history.entries.map(({ frame }) => frame.index), [0, 1, 2, 3]);
  assert.deepEqual(history.entries.map(({ startsEpisode }) => startsEpisode), [true, false, false, false]);
  const [rate] = history.last?.rates.values() ?? [];
  assert.ok(Math.abs((rate ?? 0) - 10) < 1e-3);
});
