import assert from "node:assert/strict";
import { test } from "node:test";

import { toldAt } from "../src/replay/told.ts";

const kGoals = [
  { time: 0, name: "command", type: "vec2", unit: "m/s", value: [0.25, -0.5] },
  { time: 0, name: "walks", type: "bool", unit: "", value: [1] },
  { time: 2.5, name: "command", type: "vec2", unit: "m/s", value: [0, 0] },
];

test("a goal holds until it is drawn again", () => {
  assert.equal(toldAt(kGoals, 2.49), "command 0.25, −0.5 m/s\nwalks true");
  assert.equal(toldAt(kGoals, 2.5), "command 0, 0 m/s\nwalks true");
});

test("who is told nothing sees nothing", () => {
  assert.equal(toldAt([], 1), "");
});
