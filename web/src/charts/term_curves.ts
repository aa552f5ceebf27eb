// The return by reward term: the running mean of each reward term's sum per episode.

import type { Curve, Report } from "../data/report_data.ts";
import { runningMean } from "../data/statistics.ts";
import { onlyUnder, versionStarts } from "../data/versions.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { element, onThemeChange, readout } from "../page/dom.ts";
import { ChangeMarks } from "./change_marks.ts";
import { EpisodeChart } from "./episode_chart.ts";
import { ExportButtons } from "./export_buttons.ts";
import { seriesColor } from "./series.ts";

export class TermCurves {
  private readonly chart: EpisodeChart;
  private readonly outputs: HTMLElement[] = [];
  private means: Float32Array[];

  constructor(
    private readonly report: Report,
    private readonly parts: Record<"chart" | "legend" | "caption" | "exports", HTMLElement>,
    window: number,
  ) {
    this.means = this.meansOf(window);
    const changes = new ChangeMarks(report.changes, true);
    report.terms.forEach((term, i) => this.parts.legend.append(this.legendEntry(term, i)));
    this.chart = new EpisodeChart(parts.chart, {
      episode: report.episode,
      series: this.means.map((values, i) => ({
        name: report.terms[i]?.name ?? "",
        values,
        color: seriesColor(i),
        kind: "line",
        hasGaps: true,
        starts: versionStarts(report),
      })),
      height: 260,
      label: "Running mean of each reward term's sum per episode.",
      onHover: (index) => this.showValues(index),
      onDraw: (plot) => changes.place(plot),
    });
    parts.exports.append(new ExportButtons("terms", () => this.chart).element);
    onThemeChange(() => this.chart.redraw());
    this.showValues(null);
  }

  setWindow(window: number): void {
    this.means = this.meansOf(window);
    this.means.forEach((values, i) => this.chart.setValues(i, values));
    this.showValues(null);
  }

  /** A term's mean begins anew with each task, which may pay it otherwise. */
  private meansOf(window: number): Float32Array[] {
    const starts = versionStarts(this.report);
    return this.report.terms.map(({ values, tasks }) =>
      onlyUnder(this.report, tasks, runningMean(values, window, starts)),
    );
  }

  /** A switch for the term's curve, which also shows its value. */
  private legendEntry(term: Curve, index: number): HTMLElement {
    const output = readout({ class: "value" });
    this.outputs.push(output);
    const swatch = element("span", { class: "swatch", "aria-hidden": "true" });
    swatch.style.background = `var(${seriesColor(index)})`;
    const name = element("span", { class: "name" }, term.name);
    const entry = element(
      "button",
      { type: "button", "aria-pressed": "true" },
      swatch,
      name,
      output,
    );
    if (term.doc) entry.append(element("span", { class: "doc" }, term.doc));
    entry.addEventListener("click", () => {
      const visible = entry.getAttribute("aria-pressed") !== "true";
      entry.setAttribute("aria-pressed", String(visible));
      this.chart.setVisible(index, visible);
    });
    return entry;
  }

  private showValues(index: number | null): void {
    const at = index ?? this.report.episode.length - 1;
    this.outputs.forEach((output, i) => {
      output.textContent = formatNumber(this.means[i]?.[at]);
    });
    const episode = formatCount(this.report.episode[at] ?? 0);
    this.parts.caption.textContent = `running mean at episode ${episode}`;
  }
}
