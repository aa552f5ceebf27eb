import assert from "node:assert/strict";
import { test } from "node:test";

import { presentOf, rateOf, sumOf, type PresentTask } from "../src/live/editor/present.ts";
import type { Entry } from "../src/live/history.ts";
import { frameOf, layoutOf, value } from "./frames.ts";

const feet = ["left_foot", "right_foot"];
const layout = layoutOf([
  value("term", "forward", "real"),
  value("sensor", "base.velocity", "vec3", {
    unit: "m/s",
    size: 3,
    elements: ["base.velocity.x", "base.velocity.y", "base.velocity.z"],
  }),
  value("sensor", "contact", "bool[link]", { size: 2, elements: feet.map((foot) => `contact[${foot}]`) }),
  value("sensor", "joint.angle", "real[joint]", { unit: "rad", size: 5 }),
  value("goal", "side", "int"),
]);
const numbers = [0.5, 2.5, 0, 12, 0.1, -0.2, 3e-9, 1, 0, 1, 2, 3, 4, 5, 1];

const frame = frameOf(layout, numbers);
const [forward] = layout.values;
const entry: Entry = {
  frame,
  startsEpisode: false,
  rates: new Map(forward ? [[forward, 0.75]] : []),
  ofAction: new Map(),
};
const task: PresentTask = {
  layout,
  params: [
    { name: "cost", value: 4, unit: "J", doc: "" },
    { name: "is_strict", value: true, unit: "", doc: "" },
  ],
};

const wordsOf = (name: string): string | undefined => {
  const present = presentOf(name, task);
  return present && [present.at(entry), present.unit].filter(Boolean).join(" ");
};

test("a term is worth what it pays now, and has paid", () => {
  assert.equal(rateOf("forward", task)?.at(entry), "0.750");
  assert.equal(sumOf("forward", task)?.at(entry), "12.00");
  assert.equal(rateOf("side", task), undefined, "it is no term");
});

test("a name stands for the number that it leads to", () => {
  assert.equal(wordsOf("base.velocity.y"), "\u22120.200 m/s");
  assert.equal(wordsOf("contact[left_foot]"), "true");
  assert.equal(wordsOf("side"), "1");
  assert.equal(wordsOf("time"), "0.50 s");
});

test("a name of several numbers stands for those", () => {
  assert.equal(wordsOf("base.velocity"), "0.100  \u22120.200  0.000 m/s");
  assert.equal(wordsOf("base.velocity.zx"), "0.000  0.100 m/s");
  assert.equal(wordsOf("contact"), "1 of 2");
  assert.equal(wordsOf("contact[foot]"), "1 of 2", "which one is not known");
});

test("a param has the value that it was given", () => {
  assert.equal(wordsOf("cost"), "4 J");
  assert.equal(wordsOf("is_strict"), "true");
});

test("of what the run does not tell there is nothing", () => {
  assert.equal(presentOf("speed", task), undefined);
  assert.equal(presentOf("base.velocity_limit", task), undefined);
  assert.equal(presentOf("joint.angle[hip]", task), undefined, "five numbers say nothing at a glance");
});
