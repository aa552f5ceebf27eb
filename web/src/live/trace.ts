// A small picture of what a value was in the last seconds.

import { clearedContext } from "../page/canvas.ts";
import { element, themeColor } from "../page/dom.ts";
import { kPast, type Entry } from "./history.ts";

const kHeight = 30; // [CSS pixels]
const kMostLines = 24;

export type NumberAt = (entry: Entry, line: number) => number;

export class Trace {
  readonly canvas = element("canvas", { class: "trace", height: String(kHeight), "aria-hidden": "true" });
  private readonly lines: number;

  constructor(
    lines: number,
    private readonly numberAt: NumberAt,
    private readonly color = "--accent",
  ) {
    this.lines = Math.min(lines, kMostLines);
  }

  draw(entries: Entry[]): void {
    const context = clearedContext(this.canvas, this.canvas.clientWidth, kHeight);
    if (!context) return;
    const width = this.canvas.clientWidth;
    const [low, high] = this.range(entries);
    if (low > high) return;
    const y = (value: number): number =>
      high > low ? 2 + ((high - value) / (high - low)) * (kHeight - 4) : kHeight / 2;
    if (low < 0 && high > 0) {
      context.fillStyle = themeColor("--line");
      context.fillRect(0, Math.round(y(0)), width, 1);
    }
    context.strokeStyle = themeColor(this.color);
    context.globalAlpha = this.lines > 4 ? 0.4 : 1;
    context.lineWidth = this.lines > 4 ? 1 : 1.4;
    context.lineJoin = "round";
    for (let line = 0; line < this.lines; ++line) this.drawLine(context, entries, line, y, width);
    context.globalAlpha = 1;
  }

  private drawLine(
    context: CanvasRenderingContext2D,
    entries: Entry[],
    line: number,
    y: (value: number) => number,
    width: number,
  ): void {
    context.beginPath();
    let isDrawing = false;
    entries.forEach((entry, i) => {
      const value = this.numberAt(entry, line);
      const x = width * (1 - (entries.length - 1 - i) / (kPast - 1));
      if (!Number.isFinite(value) || entry.startsEpisode) isDrawing = false;
      if (!Number.isFinite(value)) return;
      if (isDrawing) context.lineTo(x, y(value));
      else context.moveTo(x, y(value));
      isDrawing = true;
    });
    context.stroke();
  }

  private range(entries: Entry[]): [number, number] {
    let [low, high] = [Infinity, -Infinity];
    for (const entry of entries) {
      for (let line = 0; line < this.lines; ++line) {
        const value = this.numberAt(entry, line);
        if (!Number.isFinite(value)) continue;
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    }
    return [low, high];
  }
}
