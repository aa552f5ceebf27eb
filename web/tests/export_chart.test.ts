import assert from "node:assert/strict";
import { test } from "node:test";

import { chartToCsv, chartToSvg, ticksIn } from "../src/charts/export_chart.ts";
import type { ChartSeries } from "../src/charts/series.ts";

const episode = Float32Array.of(1, 2, 3, 4);
const points: ChartSeries = { name: "a<b", values: Float32Array.of(1, NaN, 3, 4), color: "--point", kind: "points" };
const line: ChartSeries = {
  name: 'a, "b"',
  values: Float32Array.of(0.5, 1, NaN, 2),
  color: "--accent",
  kind: "line",
  hasGaps: true,
};

test("a table has a row for each episode, with nothing where there is no value", () => {
  assert.equal(
    chartToCsv({ episode, series: [points, line] }),
    'episode,a<b,"a, ""b"""\n1,1,0.5\n2,,1\n3,3,\n4,4,2\n',
  );
});

test("a drawing has what is visible, broken where there are no values", () => {
  const picture = { episode, series: [points, line], isVisible: [true, true], x: [1, 4], y: [0, 4] } as const;
  const svg = chartToSvg({ ...picture, bands: [], isVisible: [...picture.isVisible], series: [...picture.series], x: [1, 4], y: [0, 4] }, (name) => name);
  assert.match(svg, /<title>a&#60;b<\/title>/);
  const [, path = ""] = /d="(M[^"]*)" stroke="--accent"/.exec(svg) ?? [];
  assert.equal(path.split("M").length - 1, 2);
  assert.ok(!/NaN/.test(svg));
  const hidden = chartToSvg({ episode, series: [line], bands: [], isVisible: [false], x: [1, 4], y: [0, 4] }, (name) => name);
  assert.ok(!hidden.includes("--accent"));
});

test("ticks are round and lie in the range", () => {
  assert.deepEqual(ticksIn([0, 10], 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticksIn([-3, 7], 5), [-2, 0, 2, 4, 6]);
  assert.deepEqual(ticksIn([2, 2], 5), [2]);
});
