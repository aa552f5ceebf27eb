import assert from "node:assert/strict";
import { test } from "node:test";

import { Terrain } from "../src/replay/terrain.ts";

test("without a ground of its own a run is on flat ground", () => {
  assert.equal(new Terrain(undefined).heightAt(3, -2), 0);
});

test("a slope rises against its normal", () => {
  const terrain = new Terrain({ normal: [-0.6, 0, 0.8], blocks: [] });
  assert.ok(Math.abs(terrain.heightAt(4, 7) - 3) < 1e-12);
});

test("each step is as high as it says", () => {
  const blocks = [
    { low_x: 1, high_x: 1.5, height: 0.1 },
    { low_x: 1.5, high_x: 101.5, height: 0.2 },
  ];
  const terrain = new Terrain({ normal: [0, 0, 1], blocks });
  assert.deepEqual(
    [0.9, 1, 1.6, 40].map((x) => terrain.heightAt(x, 0)),
    [0, 0.1, 0.2, 0.2],
  );
});

test("hills are straight between their heights, and end", () => {
  const hills = {
    columns: 2,
    rows: 2,
    size: [2, 4] as [number, number],
    center: [1, 0] as [number, number],
    heights: [0, 1, 0, 3],
  };
  const terrain = new Terrain({ normal: [0, 0, 1], blocks: [], hills });
  assert.equal(terrain.heightAt(1, 2), 1.5);
  assert.equal(terrain.heightAt(2, 0), 2);
  assert.equal(terrain.heightAt(3, 0), 0);
});
