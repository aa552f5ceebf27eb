// The curves of all runs of an experiment, and their mean with its confidence interval.

import { EpisodeChart } from "../charts/episode_chart.ts";
import { ExportButtons } from "../charts/export_buttons.ts";
import { chartOfRuns, kBeforeRuns } from "../charts/run_curves.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { element, onThemeChange } from "../page/dom.ts";
import type { Experiment } from "./data.ts";
import { colorOf } from "./words.ts";

const kHint = "Point at the curves for their values; drag to zoom, double-click to see all.";
export class Curves {
  private readonly chart: EpisodeChart;
  private readonly readout = element("p", { class: "readout", "aria-live": "polite" });

  constructor(
    private readonly experiment: Experiment,
    host: HTMLElement,
  ) {
    const { curve, runs } = experiment;
    const chart = element("div", { class: "chart" });
    const exports = new ExportButtons(experiment.name, () => this.chart).element;
    host.append(this.key(), chart, element("div", { class: "card-note" }, this.readout, exports));
    const colored = runs.map((run) => ({ name: run.name, values: run.curve, color: colorOf(run.group) }));
    this.chart = new EpisodeChart(chart, {
      ...chartOfRuns(curve.episodes, curve, colored),
      height: 330,
      sync: experiment.name,
      label: `Moving averages of the returns of ${runs.length} runs, and their mean.`,
      onHover: (index) => this.showValues(index),
    });
    onThemeChange(() => this.chart.redraw());
    this.showValues(null);
  }

  /** Lets only these runs stand out; all, where there are none. */
  emphasize(runs: number[]): void {
    this.chart.emphasize((series) => runs.length === 0 || runs.includes(series - kBeforeRuns));
  }

  private key(): HTMLElement {
    const line = (color: string): HTMLElement => {
      const dash = element("span", { class: "dash" });
      dash.style.background = `var(${color})`;
      return dash;
    };
    return element(
      "ul",
      { class: "key" },
      element("li", {}, line(colorOf(0)), `a run, mean of ${this.experiment.mean_over} episodes`),
      element("li", {}, line("--ink"), "mean of the runs"),
      element("li", {}, element("span", { class: "block" }), "its 95 % confidence interval"),
    );
  }

  private showValues(index: number | null): void {
    const { curve, runs } = this.experiment;
    if (index === null) {
      this.readout.textContent = kHint;
      return;
    }
    const values = runs.map((run) => run.curve[index]).filter((value) => value !== undefined);
    const words = [
      `Episode ${formatCount(curve.episodes[index] ?? 0)}`,
      `mean ${formatNumber(curve.mean[index])}`,
    ];
    if (Number.isFinite(curve.low[index])) {
      words.push(`95 %: ${formatNumber(curve.low[index])} … ${formatNumber(curve.high[index])}`);
    }
    const [least, greatest] = [Math.min(...values), Math.max(...values)].map(formatNumber);
    words.push(`runs ${least} … ${greatest}`);
    this.readout.textContent = words.join("  ·  ");
  }
}
