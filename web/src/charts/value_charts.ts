// One small chart for each metric, what the user really wants, and for each log.

import type { Curve, Report } from "../data/report_data.ts";
import { runningMean } from "../data/statistics.ts";
import { onlyUnder } from "../data/versions.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { element, onThemeChange } from "../page/dom.ts";
import { EpisodeChart } from "./episode_chart.ts";

const kReductionWords: Record<string, string> = {
  last: "at the end of the episode",
  max: "greatest in the episode",
  min: "least in the episode",
  sum: "sum over the episode",
  mean: "mean over the episode",
};

class ValueChart {
  private readonly chart: EpisodeChart;
  private readonly value = element("output", { class: "value" });
  private mean: Float32Array;

  constructor(
    private readonly report: Report,
    private readonly curve: Curve,
    host: HTMLElement,
    window: number,
  ) {
    this.mean = this.meanOf(window);
    const unit = curve.unit ? ` [${curve.unit}]` : "";
    const words = [kReductionWords[curve.reduction] ?? curve.reduction, curve.doc];
    const heading = element("h3", {}, `${curve.name}${unit}`);
    const note = element("p", { class: "note" }, words.filter(Boolean).join(" — "));
    const chart = element("div", { class: "chart" });
    host.append(element("article", {}, element("header", {}, heading, this.value), note, chart));
    this.chart = new EpisodeChart(chart, {
      episode: report.episode,
      series: [
        { values: curve.values, color: "--point", kind: "points" },
        { values: this.mean, color: "--accent", kind: "line", hasGaps: true },
      ],
      height: 190,
      label: `${curve.name} of each episode and its running mean.`,
      onHover: (index) => this.showValue(index),
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
