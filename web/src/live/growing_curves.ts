// Charts over the episodes that grow with the run.

import type uPlot from "uplot";

import { ChangeMarks } from "../charts/change_marks.ts";
import { EpisodeChart } from "../charts/episode_chart.ts";
import { ExportButtons } from "../charts/export_buttons.ts";
import { shadowColor, type ChartSeries } from "../charts/series.ts";
import { addValueCard } from "../charts/value_card.ts";
import type { Change } from "../data/report_data.ts";
import {
  kWindows,
  runningMean,
  runningMeanWhereThere,
  usualWindow,
} from "../data/statistics.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { byId, element, onThemeChange } from "../page/dom.ts";
import type { GrowingCurve, GrowingRecord } from "./growing_record.ts";

const kKinds = { term: "reward term", metric: "metric", learner: "learner", shadow: "shadow" };

/** Draws the values and their running mean; replaced where another set of series is needed. */
class GrowingChart {
  private chart: EpisodeChart | undefined;
  private names = ""; // of its series

  constructor(
    private readonly host: HTMLElement,
    private readonly options: {
      height: number;
      label: string;
      onHover: (index: number | null) => void;
      onDraw?: (plot: uPlot) => void;
    },
  ) {}

  draw(episode: Float32Array, series: ChartSeries[]): void {
    if (episode.length === 0) return;
    const names = series.map(({ name }) => name).join("\n");
    if (this.chart && this.names === names) {
      this.chart.extend(episode, series.map(({ values }) => values));
      return;
    }
    this.chart?.destroy();
    this.chart = new EpisodeChart(this.host, { episode, series, ...this.options });
    this.names = names;
  }

  redraw(): void {
    this.chart?.redraw();
  }

  get drawn(): EpisodeChart | undefined {
    return this.chart;
  }
}

class CurveCard {
  private readonly chart: GrowingChart;
  private readonly value: HTMLElement;
  private shownAt: number | null = null;

  constructor(
    host: HTMLElement,
    private readonly curve: GrowingCurve,
    private readonly record: GrowingRecord,
  ) {
    const words = [kKinds[curve.kind], curve.doc].filter(Boolean).join(": ");
    const card = addValueCard(host, curve, words, () => this.chart.drawn);
    this.value = card.value;
    this.chart = new GrowingChart(card.chart, {
      height: 150,
      label: `${curve.name} of each episode and its running mean.`,
      onHover: (index) => {
        this.shownAt = index;
        this.showValue();
      },
    });
    onThemeChange(() => this.chart.redraw());
  }

  draw(episode: Float32Array, window: number): void {
    const values = Float32Array.from(this.curve.values);
    this.chart.draw(episode, [
      { name: this.curve.name, values, color: "--point", kind: "points" },
      { name: "mean", values: runningMean(values, window), color: "--accent", kind: "line", hasGaps: true },
    ]);
    this.showValue();
  }

  private showValue(): void {
    const at = this.shownAt ?? this.record.episodes.length - 1;
    const episode = this.record.episodes[at];
    if (episode === undefined) return;
    const words = episodesInWords(episode, this.record.episodesPerRow).toLowerCase();
    this.value.textContent = `${words}: ${formatNumber(this.curve.values[at])}`;
  }
}

export class GrowingCurves {
  private readonly curve: GrowingChart;
  private readonly readout = byId("curve-readout", HTMLElement);
  private readonly key = byId("curve-key", HTMLElement);
  private readonly select = byId("window", HTMLSelectElement);
  private readonly cards = new Map<GrowingCurve, CurveCard>();
  private marks = new ChangeMarks([]);
  private lastMark: Change | undefined;
  private isWindowChosen = false;
  private cardsAreOld = false;
  private shownAt: number | null = null;
  private mean: Float32Array = new Float32Array();

  constructor(private readonly record: GrowingRecord) {
    this.select.append(...kWindows.map((choice) => element("option", {}, String(choice))));
    this.select.addEventListener("change", () => {
      this.isWindowChosen = true;
      this.draw();
    });
    this.curve = new GrowingChart(byId("curve", HTMLElement), {
      height: 300,
      label: "Return of each episode and its running mean. The arrow keys move from one to the next.",
      onHover: (index) => {
        this.shownAt = index;
        this.showValues();
      },
      onDraw: (plot) => this.marks.place(plot),
    });
    onThemeChange(() => this.curve.redraw());
    byId("curve-export", HTMLElement).append(
      new ExportButtons("returns", () => this.curve.drawn).element,
    );
  }

  draw(): void {
    const { record } = this;
    const episode = Float32Array.from(record.episodes);
    const count = record.episodes.at(-1) ?? 0;
    if (!this.isWindowChosen) this.select.value = String(usualWindow(count));
    const window = record.rowsOf(Number(this.select.value));
    this.renewMarks();
    const returns = Float32Array.from(record.returns);
    this.mean = runningMean(returns, window);
    const shadows = record.curvesOf("shadow");
    this.curve.draw(episode, [
      { name: "return", values: returns, color: "--point", kind: "points" },
      { name: "mean", values: this.mean, color: "--accent", kind: "line", hasGaps: true },
      ...shadows.map(({ name, values }, i): ChartSeries => ({
        name: `${name}, mean`,
        values: runningMeanWhereThere(values, window),
        color: shadowColor(i),
        kind: "line",
        hasGaps: true,
      })),
    ]);
    this.showKey(shadows);
    this.showValues();
    this.cardsAreOld = true;
    this.drawCards();
  }

  /** The charts below, once they are in sight. */
  drawCards(): void {
    if (!this.cardsAreOld || !isInSight(byId("curves", HTMLElement))) return;
    this.cardsAreOld = false;
    const episode = Float32Array.from(this.record.episodes);
    const window = this.record.rowsOf(Number(this.select.value));
    for (const each of this.record.curves) this.cardOf(each)?.draw(episode, window);
  }

  private cardOf(curve: GrowingCurve): CurveCard | undefined {
    if (curve.kind === "shadow") return undefined; // it is in the learning curve
    const known = this.cards.get(curve);
    if (known) return known;
    const card = new CurveCard(byId("curves", HTMLElement), curve, this.record);
    this.cards.set(curve, card);
    return card;
  }

  private renewMarks(): void {
    if (this.lastMark === this.record.changes.at(-1)) return;
    this.lastMark = this.record.changes.at(-1);
    this.marks.remove();
    this.marks = new ChangeMarks(this.record.changes);
  }

  private showKey(shadows: GrowingCurve[]): void {
    const item = (mark: string, words: string, color?: string): HTMLElement => {
      const sign = element("span", { class: mark });
      if (color) sign.style.background = `var(${color})`;
      return element("li", {}, sign, words);
    };
    this.key.replaceChildren(
      item("dot", this.record.episodesPerRow === 1 ? "return of an episode" : `mean return of ${this.record.episodesPerRow} episodes`),
      item("dash", "running mean"),
      ...shadows.map(({ name }, i) => item("dash", `shadow ${name}, running mean`, shadowColor(i))),
      ...(this.lastMark ? [item("bar-mark", "change")] : []),
    );
  }

  private showValues(): void {
    const { record } = this;
    const at = this.shownAt ?? record.episodes.length - 1;
    if (at < 0) {
      this.readout.textContent = "The first episode is not over yet.";
      return;
    }
    const words = [
      episodesInWords(record.episodes[at] ?? 0, record.episodesPerRow),
      `return ${formatNumber(record.returns[at])}`,
      `mean ${formatNumber(this.mean[at])}`,
    ];
    for (const { name, values } of record.curvesOf("shadow")) {
      if (Number.isFinite(values[at])) words.push(`${name} ${formatNumber(values[at])}`);
    }
    if (at === record.episodes.length - 1 && record.lastEnd) words.push(record.lastEnd);
    this.readout.textContent = words.join("  ·  ");
  }
}

/** "Episode 12"; where each row is the mean of several, "Episodes 9 to 12". */
const episodesInWords = (last: number, perRow: number): string =>
  perRow === 1
    ? `Episode ${formatCount(last)}`
    : `Episodes ${formatCount(Math.max(1, last - perRow + 1))} to ${formatCount(last)}`;

/** Or about to be. */
function isInSight(part: HTMLElement): boolean {
  const { top, bottom } = part.getBoundingClientRect();
  return bottom > -window.innerHeight && top < 2 * window.innerHeight;
}
