import assert from "node:assert/strict";
import { test } from "node:test";

import { knownAt, Lets, type KnownNumbers, type LetWorth } from "../src/live/editor/lets.ts";
import type { PresentTask } from "../src/live/editor/present.ts";
import type { Entry } from "../src/live/history.ts";
import { frameOf, layoutOf, value } from "./frames.ts";

const layout = layoutOf([
  value("term", "forward", "real"),
  value("sensor", "base.velocity", "vec3", { size: 3 }),
  value("goal", "side", "int"),
  value("memory", "last", "real"),
]);
const entry: Entry = {
  frame: frameOf(layout, [0.5, 2.5, 0, 12, 1, -2, 0.25, 1, NaN]),
  startsEpisode: false,
  rates: new Map(),
  ofAction: new Map(),
};
const task: PresentTask = {
  layout,
  params: [
    { name: "cost", value: 4, unit: "J", doc: "" },
    { name: "is_strict", value: true, unit: "", doc: "" },
    { name: "mode", value: "slow", unit: "", doc: "" },
  ],
};

const worth = (name: string, numbers: number[], type = "real", unit = ""): LetWorth => ({ name, type, unit, numbers });

test("what is known is what a task can read, where it is a number", () => {
  assert.deepEqual(knownAt(entry, task), {
    time: [0.5],
    "base.velocity": [1, -2, 0.25],
    side: [1],
    cost: [4],
    is_strict: [1],
  });
});

test("a let is worth what the server has found", async () => {
  const asked: KnownNumbers[] = [];
  let redrawn = 0;
  const lets = new Lets(
    (known) => {
      asked.push(known);
      return Promise.resolve([
        worth("lean", [0.5], "real", "rad"),
        worth("is_up", [1], "bool"),
        worth("all", [1, 2, 3, 4, 5], "real[joint]"),
      ]);
    },
    () => ++redrawn,
  );
  assert.equal(lets.presentOf("lean"), undefined);
  await lets.update(entry, task);
  assert.deepEqual(asked, [knownAt(entry, task)]);
  assert.equal(redrawn, 1);
  assert.equal(lets.presentOf("lean")?.at(entry), "0.500");
  assert.equal(lets.presentOf("lean")?.unit, "rad");
  assert.equal(lets.presentOf("is_up")?.at(entry), "true");
  assert.equal(lets.presentOf("all"), undefined, "so many numbers say nothing at a glance");
});

test("the server is asked a few times a second, once at a time, and the page redrawn for other names only", async (t) => {
  let now = 1000;
  t.mock.method(performance, "now", () => now);
  let answers = [worth("lean", [0.5])];
  let [asked, redrawn] = [0, 0];
  const lets = new Lets(
    () => (++asked, Promise.resolve(answers)),
    () => ++redrawn,
  );
  await Promise.all([lets.update(entry, task), lets.update(entry, task)]);
  await lets.update(entry, task);
  assert.equal(asked, 1);
  now += 250;
  answers = [worth("lean", [0.75])];
  await lets.update(entry, task);
  assert.deepEqual([asked, redrawn], [2, 1]);
  assert.equal(lets.presentOf("lean")?.at(entry), "0.750");
  now += 250;
  answers = [worth("tilt", [0.75])];
  await lets.update(entry, task);
  assert.equal(redrawn, 2);
  assert.equal(lets.presentOf("lean"), undefined);
});

test("where the server cannot say it, what it said last stays", async (t) => {
  let now = 1000;
  t.mock.method(performance, "now", () => now);
  let answer: () => Promise<LetWorth[] | null> = () => Promise.resolve([worth("lean", [0.5])]);
  const lets = new Lets(
    () => answer(),
    () => undefined,
  );
  await lets.update(entry, task);
  for (const next of [() => Promise.resolve(null), () => Promise.reject(new Error("gone"))]) {
    now += 250;
    answer = next;
    await lets.update(entry, task);
    assert.equal(lets.presentOf("lean")?.at(entry), "0.500");
  }
});
