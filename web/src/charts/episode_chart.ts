// A chart over the episodes: what the page's charts have in common.

import uPlot from "uplot";

import { formatCount, formatTick } from "../data/words.ts";
import { themeColor } from "../page/dom.ts";
import type { ChartPicture } from "./export_chart.ts";
import { drawPoints } from "./points.ts";
import type { ChartSeries } from "./series.ts";

/** What is filled between two of the series. */
export interface Band {
  upper: number;
  lower: number;
  color: string;
  opacity?: number; // of a color that is opaque
}

export interface ChartOptions {
  episode: Float32Array;
  series: ChartSeries[];
  bands?: Band[];
  height: number;
  sync?: string; // charts with the same word move their cursors together
  label: string; // for those who cannot see it
  onHover?: (index: number | null) => void;
  onDraw?: (plot: uPlot) => void;
}

const kFont = "12px system-ui, sans-serif";
const kEpisodeSync = "episode";
const kFaint = 0.12; // opacity of what is not emphasized

/** Between two marks of the axis: whole episodes. */
const kEpisodeSteps = Array.from({ length: 21 }, (_, i) => {
  const digit = [1, 2, 5][i % 3] as number;
  return digit * 10 ** Math.floor(i / 3);
});

const kLeastWidth = 56; // the charts of a page stand in line where their numbers are short
const kGap = 6;

/** As wide as the longest of the axis's numbers: one that is cut is another number. */
function widthOfValues(plot: uPlot, values: string[] | null, index: number): number {
  const font = plot.axes[index]?.font as unknown as [string]; // in the pixels of the canvas
  plot.ctx.font = font[0];
  const widths = (values ?? []).map((value) => plot.ctx.measureText(value).width);
  const longest = Math.max(0, ...widths) / window.devicePixelRatio;
  return Math.max(kLeastWidth, Math.ceil(longest) + kGap + 2);
}

function axis(side: number, format: (value: number) => string): uPlot.Axis {
  const isBottom = side === 2;
  return {
    side,
    stroke: () => themeColor("--ink-soft"),
    font: kFont,
    size: isBottom ? 28 : widthOfValues,
    ...(isBottom ? { label: "episode", labelSize: 18, labelGap: 0, labelFont: kFont } : {}),
    gap: kGap,
    space: isBottom ? 70 : 36,
    ...(isBottom ? { incrs: kEpisodeSteps } : {}),
    grid: { stroke: () => themeColor("--grid"), width: 1 },
    ticks: { show: false },
    values: (_, splits) => splits.map((value) => (value === null ? "" : format(value))),
  };
}

/** `gaps`, and one more before each of `starts` where values stand on both sides; in their order. */
function withBreaks(
  plot: uPlot,
  index: number,
  starts: number[],
  gaps: uPlot.Series.Gaps,
): uPlot.Series.Gaps {
  const [episodes, values] = [plot.data[0], plot.data[index] ?? []];
  const has = (i: number): boolean => (values[i] ?? null) !== null;
  const x = (i: number): number => plot.valToPos(episodes[i] as number, "x", true);
  const breaks = starts
    .filter((start) => has(start - 1) && has(start))
    .map((start): uPlot.Series.Gap => [x(start - 1), x(start)]);
  return [...gaps, ...breaks].sort((a, b) => a[0] - b[0]);
}

function plotSeries(series: ChartSeries): uPlot.Series {
  const isLine = series.kind === "line";
  return {
    stroke: () => themeColor(series.color),
    width: series.width ?? 2,
    points: { show: false },
    spanGaps: !series.hasGaps,
    gaps: (plot, index, _first, _last, gaps) => withBreaks(plot, index, series.starts ?? [], gaps),
    ...(isLine ? {} : { paths: () => null }), // drawn by drawPoints
  };
}

/** Colors of the style sheet are "#rrggbb". */
const plotBand = ({ upper, lower, color, opacity }: Band): uPlot.Band => ({
  series: [upper + 1, lower + 1],
  fill: () => {
    const alpha = opacity === undefined ? "" : Math.round(255 * opacity).toString(16).padStart(2, "0");
    return themeColor(color) + alpha;
  },
});

function drawZeroLine(plot: uPlot): void {
  const { min, max } = plot.scales["y"] as uPlot.Scale;
  if (min === undefined || max === undefined || min >= 0 || max <= 0) return;
  const y = Math.round(plot.valToPos(0, "y", true));
  const { left, width } = plot.bbox;
  plot.ctx.fillStyle = themeColor("--zero");
  plot.ctx.fillRect(left, y, width, window.devicePixelRatio);
}

/** Lets a view that reaches the first or the last episode reach a little further. */
const rangeOf: uPlot.Range.Function = (plot, low, high) => {
  const episodes = plot.data[0] ?? [];
  const first = episodes[0] ?? 0;
  const last = episodes[episodes.length - 1] ?? 1;
  const room = Math.max(1, (last - first) * 0.01);
  return [low <= first ? first - room : low, high >= last ? last + room : high];
};

function plotOptions(options: ChartOptions, width: number): uPlot.Options {
  return {
    width,
    height: options.height,
    padding: [10, 24, 0, 0],
    legend: { show: false },
    scales: { x: { time: false, range: rangeOf } },
    axes: [axis(2, formatCount), axis(3, formatTick)],
    series: [{}, ...options.series.map(plotSeries)],
    bands: (options.bands ?? []).map(plotBand),
    cursor: {
      y: false,
      points: { show: false },
      sync: { key: options.sync ?? kEpisodeSync, setSeries: false, scales: ["x", null] },
      drag: { x: true, y: false, dist: 5 },
    },
    hooks: {
      drawAxes: [drawZeroLine, (plot) => drawPoints(plot, options.series)],
      draw: [(plot) => options.onDraw?.(plot)],
      setCursor: [(plot) => options.onHover?.(plot.cursor.idx ?? null)],
    },
  };
}

export class EpisodeChart {
  private readonly plot: uPlot;
  private data: Float32Array[];
  private readonly resizing: ResizeObserver;
  private readonly syncKey: string;

  constructor(
    private readonly host: HTMLElement,
    private readonly options: ChartOptions,
  ) {
    this.data = [options.episode, ...options.series.map((series) => series.values)];
    this.plot = new uPlot(plotOptions(options, host.clientWidth), this.plotData(), host);
    host.setAttribute("role", "group");
    host.setAttribute("aria-label", options.label);
    host.tabIndex = 0;
    host.addEventListener("keydown", (event) => this.onKey(event));
    this.resizing = new ResizeObserver(() => this.fit(options.height));
    this.resizing.observe(host);
    this.syncKey = options.sync ?? kEpisodeSync;
    uPlot.sync(this.syncKey).sub(this.plot);
  }

  /** What it shows now, for other programs. */
  get picture(): ChartPicture {
    const [episode = new Float32Array(), ...values] = this.data;
    const range = (axis: string): [number, number] => {
      const { min = 0, max = 1 } = this.plot.scales[axis] as uPlot.Scale;
      return [min, max];
    };
    const { series, bands = [] } = this.options;
    return {
      episode,
      series: series.map((each, i) => ({ ...each, values: values[i] ?? each.values })),
      bands,
      isVisible: this.plot.series.slice(1).map(({ show }) => show !== false),
      x: range("x"),
      y: range("y"),
      canvas: this.plot.ctx.canvas,
    };
  }

  setValues(index: number, values: Float32Array): void {
    this.data[index + 1] = values;
    this.plot.setData(this.plotData(), false);
    this.plot.redraw(true);
  }

  /** More episodes, with the values of all series. A view of all of them stays one. */
  extend(episode: Float32Array, values: Float32Array[]): void {
    const { min = 0, max = 0 } = this.plot.scales["x"] as uPlot.Scale;
    const before = this.data[0] as Float32Array;
    const showsAll = min <= (before[0] ?? min) && max >= (before.at(-1) ?? max);
    this.data = [episode, ...values];
    this.plot.setData(this.plotData(), showsAll);
    if (!showsAll) this.plot.redraw(true);
  }

  setVisible(index: number, visible: boolean): void {
    this.plot.setSeries(index + 1, { show: visible });
  }

  /** Lets all series stand back but those for which `isEmphasized` holds. */
  emphasize(isEmphasized: (index: number) => boolean): void {
    this.plot.series.slice(1).forEach((series, i) => {
      series.alpha = isEmphasized(i) ? 1 : kFaint;
    });
    this.plot.redraw(false);
  }

  /** Leads the cursor to an episode by its index. */
  pointAt(index: number): void {
    const episode = this.data[0]?.[index] ?? 0;
    this.plot.setCursor({ left: this.plot.valToPos(episode, "x"), top: 0 });
  }

  redraw(): void {
    this.plot.redraw(true);
  }

  /** Takes the chart off the page. */
  destroy(): void {
    this.resizing.disconnect();
    uPlot.sync(this.syncKey).unsub(this.plot);
    this.plot.destroy();
  }

  /** Leads the cursor to the next or the previous episode by the arrow keys. */
  private onKey(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowRight: 1, PageUp: -10, PageDown: 10 }[event.key];
    if (step === undefined || event.target !== this.host) return;
    event.preventDefault();
    const episodes = this.data[0] as Float32Array;
    const last = episodes.length - 1;
    const index = Math.min(Math.max((this.plot.cursor.idx ?? last + 1) + step, 0), last);
    this.pointAt(index);
  }

  private fit(height: number): void {
    if (this.host.clientWidth > 0) this.plot.setSize({ width: this.host.clientWidth, height });
  }

  /** uPlot draws gaps where a value is null; typed arrays hold NaN there. */
  private plotData(): uPlot.AlignedData {
    return this.data.map((values) =>
      Array.from(values, (value) => (Number.isFinite(value) ? value : null)),
    ) as uPlot.AlignedData;
  }
}
