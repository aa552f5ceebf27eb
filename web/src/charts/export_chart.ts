// A chart over the episodes as a file for other programs.

import { formatTick } from "../data/words.ts";
import { themeColor } from "../page/dom.ts";
import type { Band } from "./episode_chart.ts";
import type { ChartSeries } from "./series.ts";

/** What a chart shows now. */
export interface ChartPicture {
  episode: Float32Array;
  series: ChartSeries[];
  bands: Band[];
  isVisible: boolean[]; // each of the series
  x: [number, number]; // the range of the view
  y: [number, number];
  canvas: HTMLCanvasElement;
}

const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);

/** All episodes, also those out of the view; a row for each, empty where there is no value. */
export function chartToCsv({ episode, series }: Pick<ChartPicture, "episode" | "series">): string {
  const rows = [["episode", ...series.map(({ name }) => name)].map(quoted).join(",")];
  episode.forEach((number, i) => {
    const values = series.map(({ values }) => values[i] ?? NaN);
    rows.push([number, ...values.map((value) => (Number.isFinite(value) ? value : ""))].join(","));
  });
  return rows.join("\n") + "\n";
}

export function chartToPng({ canvas }: ChartPicture): Promise<Blob> {
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext("2d") as CanvasRenderingContext2D;
  context.fillStyle = themeColor("--paper");
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(canvas, 0, 0);
  return new Promise((resolve, reject) =>
    copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture is too large"))), "image/png"),
  );
}

const kSize = { width: 900, height: 420 };
const kMargin = { left: 70, right: 20, top: 20, bottom: 50 };

/** Round numbers in the range, about `count` of them. */
export function ticksIn([low, high]: [number, number], count: number): number[] {
  const rough = (high - low) / count;
  if (!(rough > 0)) return [low];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((each) => each >= rough) ?? 10 * power;
  const ticks: number[] = [];
  for (let tick = Math.ceil(low / step); tick * step <= high + step * 1e-9; ++tick) ticks.push(tick * step);
  return ticks;
}

const escaped = (text: string): string =>
  text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/** What is in view, with its axes and a key. `colorOf`: the value of a color of the style sheet. */
export function chartToSvg(
  picture: Omit<ChartPicture, "canvas">,
  colorOf: (name: string) => string = themeColor,
): string {
  const { width, height } = kSize;
  const [right, bottom] = [width - kMargin.right, height - kMargin.bottom];
  const place = (range: [number, number], begin: number, end: number) => (value: number): number =>
    begin + ((value - range[0]) / (range[1] - range[0] || 1)) * (end - begin);
  const x = place(picture.x, kMargin.left, right);
  const y = place(picture.y, bottom, kMargin.top);
  const at = (value: number): string => value.toFixed(2);
  const parts = [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="sans-serif" font-size="12">`,
    `<rect width="${width}" height="${height}" fill="${colorOf("--paper")}"/>`,
    `<clipPath id="view"><rect x="${kMargin.left}" y="${kMargin.top}" width="${right - kMargin.left}" height="${bottom - kMargin.top}"/></clipPath>`,
  ];
  const ink = colorOf("--ink-soft");
  for (const tick of ticksIn(picture.y, 6)) {
    parts.push(
      `<path d="M${kMargin.left} ${at(y(tick))}H${right}" stroke="${colorOf("--grid")}"/>`,
      `<text x="${kMargin.left - 8}" y="${at(y(tick) + 4)}" text-anchor="end" fill="${ink}">${formatTick(tick)}</text>`,
    );
  }
  for (const tick of ticksIn(picture.x, 8)) {
    parts.push(
      `<text x="${at(x(tick))}" y="${bottom + 18}" text-anchor="middle" fill="${ink}">${formatTick(tick)}</text>`,
    );
  }
  parts.push(`<text x="${right}" y="${bottom + 36}" text-anchor="end" fill="${ink}">episode</text>`, `<g clip-path="url(#view)">`);
  parts.push(...picture.bands.map((band) => bandOf(picture, band, x, y, colorOf)));
  picture.series.forEach((series, i) => {
    if (!picture.isVisible[i] || series.width === 0) return;
    parts.push(`<g><title>${escaped(series.name)}</title>${seriesOf(picture.episode, series, x, y, colorOf)}</g>`);
  });
  return parts.join("\n") + "\n</g>\n</svg>\n";
}

type Place = (value: number) => number;

/** Stretches of indices in which all the values are there. */
function stretchesOf(...all: Float32Array[]): number[][] {
  const stretches: number[][] = [];
  let last: number[] | undefined;
  for (let i = 0; i < (all[0]?.length ?? 0); ++i) {
    if (!all.every((values) => Number.isFinite(values[i]))) {
      last = undefined;
      continue;
    }
    if (!last) stretches.push((last = []));
    last.push(i);
  }
  return stretches;
}

function seriesOf(
  episode: Float32Array,
  { values, color, kind, width, hasGaps }: ChartSeries,
  x: Place,
  y: Place,
  colorOf: (name: string) => string,
): string {
  const stretches = stretchesOf(values);
  const point = (i: number): string => `${x(episode[i] ?? 0).toFixed(2)} ${y(values[i] ?? 0).toFixed(2)}`;
  const stroke = `stroke="${colorOf(color)}" fill="none"`;
  if (kind === "points") {
    const dots = stretches.flat().map((i) => `M${point(i)}h0`);
    return `<path d="${dots.join("")}" ${stroke} stroke-width="3" stroke-linecap="round"/>`;
  }
  const lines = hasGaps ? stretches : [stretches.flat()];
  const path = lines.filter((line) => line.length > 0).map((line) => `M${line.map(point).join("L")}`);
  return `<path d="${path.join("")}" ${stroke} stroke-width="${width ?? 2}" stroke-linejoin="round"/>`;
}

function bandOf(
  { episode, series }: Pick<ChartPicture, "episode" | "series">,
  { upper: above, lower: below, color, opacity = 1 }: Band,
  x: Place,
  y: Place,
  colorOf: (name: string) => string,
): string {
  const [upper, lower] = [series[above]?.values, series[below]?.values];
  if (!upper || !lower) return "";
  const point = (values: Float32Array) => (i: number): string =>
    `${x(episode[i] ?? 0).toFixed(2)} ${y(values[i] ?? 0).toFixed(2)}`;
  const areas = stretchesOf(upper, lower).map(
    (all) => `M${all.map(point(upper)).join("L")}L${[...all].reverse().map(point(lower)).join("L")}Z`,
  );
  return `<path d="${areas.join("")}" fill="${colorOf(color)}" fill-opacity="${opacity}"/>`;
}
