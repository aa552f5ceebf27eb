// One small chart for each metric, what the user really wants, and for each log.

import type { Curve, Report } from "../data/report_data.ts";
import { runningMean } from "../data/statistics.ts";
import { onlyUnder } from "../data/versions.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { onThemeChange } from "../page/dom.ts";
import { ChangeMarks } from "./change_marks.ts";
import { EpisodeChart } from "./episode_chart.ts";
import { addValueCard } from "./value_card.ts";

const kReductionWords: Record<string, string> = {
  last: "at the end of the episode",
  max: "maximum in the episode",
  min: "minimum in the episode",
  sum: "sum over the episode",
  mean: "mean over the episode",
};

class ValueChart {
  private readonly chart: EpisodeChart;
  private readonly value: HTMLElement;
  private mean: Float32Array;

  constructor(
    private readonly report: Report,
    private readonly curve: Curve,
    host: HTMLElement,
    window: number,
  ) {
    this.mean = this.meanOf(window);
    const words = [kReductionWords[curve.reduction] ?? curve.reduction, curve.doc];
    const card = addValueCard(host, curve, words.filter(Boolean).join(" — "), () => this.chart);
    this.value = card.value;
    const changes = new ChangeMarks(report.changes, true);
    this.chart = new EpisodeChart(card.chart, {
      episode: report.episode,
      series: [
        { name: curve.name, values: curve.values, color: "--point", kind: "points" },
        { name: "mean", values: this.mean, color: "--accent", kind: "line", hasGaps: true },
      ],
      height: 190,
      label: `${curve.name} of each episode and its running mean.`,
      onHover: (index) => this.showValue(index),
      onDraw: (plot) => changes.place(plot),
    });
    onThemeChange(() => this.chart.redraw());
    this.showValue(null);
  }

  setWindow(window: number): void {
    this.mean = this.meanOf(window);
    this.chart.setValues(1, this.mean);
    this.showValue(null);
  }

  private meanOf(window: number): Float32Array {
    const { tasks, values } = this.curve;
    return onlyUnder(this.report, tasks, runningMean(values, window));
  }

  private showValue(index: number | null): void {
    const at = index ?? this.report.episode.length - 1;
    const episode = formatCount(this.report.episode[at] ?? 0);
    const mean = `mean ${formatNumber(this.mean[at])}`;
    const value = formatNumber(this.curve.values[at]);
    this.value.textContent = index === null ? mean : `episode ${episode}: ${value}, ${mean}`;
  }
}

export class ValueCharts {
  private readonly charts: ValueChart[];

  constructor(report: Report, curves: Curve[], host: HTMLElement, window: number) {
    this.charts = curves.map((curve) => new ValueChart(report, curve, host, window));
  }

  setWindow(window: number): void {
    for (const chart of this.charts) chart.setWindow(window);
  }
}
