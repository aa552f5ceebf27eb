import assert from "node:assert/strict";
import { test } from "node:test";

import { goalsAt, placesIn, toldAt, velocitiesIn } from "../src/replay/told.ts";

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

test("places and velocities can be drawn, and nothing else", () => {
  const place = { time: 0, name: "target", type: "vec2", unit: "m", value: [1, 2] };
  const goals = [...goalsAt(kGoals, 1), place];
  assert.deepEqual(placesIn(goals).map(({ name }) => name), ["target"]);
  assert.deepEqual(velocitiesIn(goals).map(({ name, value }) => [name, value]), [["command", [0.25, -0.5]]]);
});
