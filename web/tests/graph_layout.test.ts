import assert from "node:assert/strict";
import { test } from "node:test";

import { columnsOf, placeGraph, type Graph } from "../src/live/graph_layout.ts";

const graph: Graph = {
  modules: [
    {
      name: "environment",
      parameters: {},
      ports: [
        { name: "time", kind: "out port", type: "real [s]" },
        { name: "spare", kind: "out port", type: "real" },
        { name: "targets", kind: "in port", type: "vector" },
      ],
    },
    { name: "task", parameters: {}, ports: [{ name: "time", kind: "in port", type: "real [s]" }] },
    { name: "mind", parameters: {}, ports: [{ name: "targets", kind: "out port", type: "vector" }] },
  ],
  connections: [
    { from: "environment.time", to: "task.time", type: "real [s]" },
    { from: "mind.targets", to: "environment.targets", type: "vector" },
  ],
};

test("what sends stands left of what receives, and what leads back changes nothing", () => {
  assert.deepEqual([...columnsOf(graph)], [["environment", 0], ["task", 1], ["mind", 0]]);
});

test("ports without a connection are shown where that is wanted", () => {
  const names = (showsAll: boolean): string[] =>
    placeGraph(graph, showsAll)[0]?.ports.map(({ port }) => port.name) ?? [];
  assert.deepEqual(names(false), ["time", "targets"]);
  assert.deepEqual(names(true), ["time", "spare", "targets"]);
});

test("modules of a column do not overlap", () => {
  const [environment, , mind] = placeGraph(graph, true);
  assert.ok(environment && mind);
  assert.equal(environment.x, mind.x);
  assert.ok(mind.y > environment.y + environment.height);
});
