import assert from "node:assert/strict";
import { test } from "node:test";

import { comparedOf, type Judgment } from "../src/live/what_if.ts";

const judgment = (more: Partial<Judgment>): Judgment => ({
  return: 0,
  end_kind: "truncated",
  end_reason: "time is up",
  end_time: 20,
  terms: {},
  metrics: {},
  ...more,
});

test("what both tasks have stands side by side, and what only one of them has", () => {
  const old = judgment({ return: 3, terms: { forward: 4, fall: -1 }, metrics: { distance: 2 } });
  const edited = judgment({ return: 8, terms: { forward: 8, effort: 0 }, metrics: { distance: 2 } });
  assert.deepEqual(comparedOf(old, edited), [
    { name: "return", kind: "return", old: 3, new: 8 },
    { name: "forward", kind: "term", old: 4, new: 8 },
    { name: "fall", kind: "term", old: -1, new: undefined },
    { name: "effort", kind: "term", old: undefined, new: 0 },
    { name: "distance", kind: "metric", old: 2, new: 2 },
  ]);
});
