// One value over an episode, drawn on a canvas as wide as the time axis.

import { clearedContext } from "../page/canvas.ts";
import { themeColor } from "../page/dom.ts";

export interface TraceData {
  times: Float64Array; // [sample] [s]
  values: Float64Array; // [sample]; NaN where there is none
  duration: number; // of the axis [s]
  beside?: Float64Array | undefined; // values of another trace, which has the same height
}

/** Draws in CSS pixels; colors are names of the style sheet. */
export type Draw = (context: CanvasRenderingContext2D, width: number, height: number) => void;

/** A canvas that is drawn anew whenever its size or the theme may have changed. */
export class TraceCanvas {
  readonly element = document.createElement("canvas");

  constructor(
    readonly height: number,
    private readonly draw: Draw,
  ) {
    this.element.style.height = `${height}px`;
  }

  redraw(width: number): void {
    const context = clearedContext(this.element, Math.max(0, width), this.height);
    if (context) this.draw(context, width, this.height);
  }
}

interface Range {
  low: number;
  high: number;
}

/** Of the values, those beside them, and of 0 where `withZero`; 0 where there is none. */
export function extremesOf({ values, beside }: TraceData, withZero: boolean): Range {
  let [low, high] = withZero ? [0, 0] : [Infinity, -Infinity];
  for (const value of [...values, ...(beside ?? [])]) {
    if (!Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return low > high ? { low: 0, high: 0 } : { low, high };
}

/** The same with some height. */
function rangeOf(data: TraceData, withZero: boolean): Range {
  const { low, high } = extremesOf(data, withZero);
  return low === high ? { low: low - (withZero ? 0 : 0.5), high: high + 0.5 } : { low, high };
}

/** The least and the greatest value in each column of one pixel; NaN where there is none. */
export function columnsOf({ times, values, duration }: TraceData, width: number): Range[] {
  const columns = Array.from({ length: width }, (): Range => ({ low: NaN, high: NaN }));
  values.forEach((value, i) => {
    if (!Number.isFinite(value)) return;
    const x = Math.min(width - 1, Math.floor(((times[i] as number) / duration) * width));
    const column = columns[x] as Range;
    column.low = column.low <= value ? column.low : value;
    column.high = column.high >= value ? column.high : value;
  });
  return columns;
}

/** Bars from zero, as of what was paid: each reaches to the next sample. */
export const bars =
  (data: TraceData, color: string): Draw =>
  (context, width, height) => {
    const { low, high } = rangeOf(data, true);
    const y = (value: number): number => ((high - value) / (high - low)) * height;
    context.fillStyle = themeColor(color);
    let last = { low: 0, high: 0 };
    columnsOf(data, Math.round(width)).forEach((column, x) => {
      if (Number.isFinite(column.low)) last = column;
      const top = y(Math.max(0, last.high));
      const bottom = y(Math.min(0, last.low));
      if (bottom > top) context.fillRect(x, top, 1, bottom - top);
    });
    context.fillStyle = themeColor("--zero");
    context.fillRect(0, Math.min(height - 1, Math.round(y(0))), width, 1);
  };

/** A line, filled down to zero where `fills`. */
export const line =
  (data: TraceData, color: string, fills: boolean): Draw =>
  (context, width, height) => {
    const { low, high } = rangeOf(data, fills);
    const room = 2; // for the line's own width
    const y = (value: number): number =>
      room + ((high - value) / (high - low)) * (height - 2 * room);
    context.beginPath();
    let isDown = false;
    const first: [number, number] = [0, 0];
    const end: [number, number] = [0, 0];
    columnsOf(data, Math.round(width)).forEach((column, x) => {
      if (!Number.isFinite(column.low)) return;
      if (!isDown) first[0] = x;
      for (const value of column.low === column.high ? [column.low] : [column.low, column.high]) {
        if (isDown) context.lineTo(x, y(value));
        else context.moveTo(x, y(value));
        isDown = true;
      }
      end[0] = x;
    });
    context.strokeStyle = themeColor(color);
    context.lineWidth = 1.5;
    context.lineJoin = "round";
    context.stroke();
    if (!fills || !isDown) return;
    context.lineTo(end[0], y(0));
    context.lineTo(first[0], y(0));
    context.globalAlpha = 0.14;
    context.fillStyle = themeColor(color);
    context.fill();
    context.globalAlpha = 1;
    context.fillStyle = themeColor("--zero");
    context.fillRect(0, Math.min(height - 1, Math.round(y(0))), width, 1);
  };

/** Stretches of equal values that are not negative, each with its color and, where it fits, a name. */
export const stretches =
  (data: TraceData, colorOf: (value: number) => string, nameOf: (value: number) => string): Draw =>
  (context, width, height) => {
    const { times, values, duration } = data;
    const x = (i: number): number => ((times[i] ?? duration) / duration) * width;
    context.font = "11px system-ui, sans-serif";
    context.textBaseline = "middle";
    for (let start = 0; start < values.length; ) {
      const value = values[start] as number;
      let next = start + 1;
      while (next < values.length && values[next] === value) ++next;
      if (value >= 0) {
        const length = Math.max(1, x(next) - x(start));
        context.fillStyle = themeColor(colorOf(value));
        context.fillRect(x(start), 1, Math.max(1, length - 1), height - 2);
        const name = nameOf(value);
        context.fillStyle = themeColor("--paper");
        if (name && context.measureText(name).width + 8 < length) {
          context.fillText(name, x(start) + 4, height / 2 + 0.5);
        }
      }
      start = next;
    }
  };

/** Marks of the time axis [s], at most one each 60 pixels. */
export function ticksOf(duration: number, width: number): number[] {
  const most = Math.max(1, width / 60);
  const power = 10 ** Math.floor(Math.log10(duration / most));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((each) => duration / each <= most);
  const ticks: number[] = [];
  for (let i = 0; step && i * step <= duration + 1e-9; ++i) ticks.push(i * step);
  return ticks;
}

export const axis =
  (duration: number, format: (time: number) => string): Draw =>
  (context, width, height) => {
    context.font = "12px system-ui, sans-serif";
    context.fillStyle = themeColor("--ink-soft");
    context.textBaseline = "bottom";
    for (const time of ticksOf(duration, width)) {
      const text = format(time);
      const half = context.measureText(text).width / 2;
      const x = Math.min(Math.max((time / duration) * width, half), width - half);
      context.fillText(text, x - half, height);
    }
  };
