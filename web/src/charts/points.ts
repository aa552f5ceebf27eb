// The faint points of a chart: one for each episode, tens of thousands at most.

import type uPlot from "uplot";

import { themeColor } from "../page/dom.ts";
import type { ChartSeries } from "./series.ts";

const kRound = 3000; // so many points are circles; more are small squares, which is faster

/** Diameter of a point: the more there are, the smaller [CSS pixels]. */
function pointSize(count: number): number {
  if (count <= 200) return 5;
  return count <= kRound ? 3.5 : 2;
}

function drawPoint(context: CanvasRenderingContext2D, x: number, y: number, size: number): void {
  context.beginPath();
  context.arc(x, y, size / 2, 0, 2 * Math.PI);
  context.fill();
}

/** So faint that the running mean stands out also where the points of a long run overlap. */
const pointOpacity = (count: number): number => Math.min(1, Math.sqrt(kRound / 2 / count));

/** Draws the series of the kind "points", each point by itself: they add up where many are. */
export function drawPoints(plot: uPlot, series: ChartSeries[]): void {
  const { ctx: context, bbox } = plot;
  const episodes = plot.data[0];
  const size = pointSize(episodes.length) * window.devicePixelRatio;
  context.save();
  context.beginPath();
  context.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  context.clip();
  context.globalAlpha = pointOpacity(episodes.length);
  series.forEach(({ kind, color }, i) => {
    if (kind !== "points") return;
    context.fillStyle = themeColor(color);
    plot.data[i + 1]?.forEach((value, at) => {
      if (value === null || value === undefined) return;
      const x = plot.valToPos(episodes[at] as number, "x", true);
      const y = plot.valToPos(value, "y", true);
      if (episodes.length <= kRound) drawPoint(context, x, y, size);
      else context.fillRect(Math.round(x - size / 2), Math.round(y - size / 2), size, size);
    });
  });
  context.restore();
}
