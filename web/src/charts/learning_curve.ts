// The return of each episode, its running mean, and a mark for each episode that can be replayed.

import type uPlot from "uplot";

import type { Recording, Report } from "../data/report_data.ts";
import { runningMean } from "../data/statistics.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { element, leaveAfterClick, onThemeChange } from "../page/dom.ts";
import { EpisodeChart } from "./episode_chart.ts";

const kHint = "Point at an episode for its values; drag to zoom, double-click to see all.";

export class LearningCurve {
  private readonly chart: EpisodeChart;
  private readonly marks = element("div", { class: "marks" });
  private mean: Float32Array;

  constructor(
    private readonly report: Report,
    private readonly parts: { chart: HTMLElement; readout: HTMLElement },
    window: number,
    private readonly replay: (recording: Recording) => void,
  ) {
    this.mean = runningMean(report.returns, window);
    this.makeMarks();
    this.chart = new EpisodeChart(parts.chart, {
      episode: report.episode,
      series: [
        { values: report.returns, color: "--point", kind: "points" },
        { values: this.mean, color: "--accent", kind: "line" },
      ],
      height: 386,
      label:
        "Return of each episode and its running mean. The arrow keys move from one to the next.",
      onHover: (index) => this.showValues(index),
      onDraw: (plot) => this.placeMarks(plot),
    });
    onThemeChange(() => this.chart.redraw());
    this.showValues(null);
  }

  setWindow(window: number): void {
    this.mean = runningMean(this.report.returns, window);
    this.chart.setValues(1, this.mean);
    this.showValues(null);
  }

  /** Shows which recording is being replayed. */
  select(recording: Recording): void {
    this.report.recordings.forEach((other, i) => {
      this.marks.children[i]?.setAttribute("aria-pressed", String(other === recording));
    });
  }

  private makeMarks(): void {
    for (const recording of this.report.recordings) {
      const value = formatNumber(this.returnOf(recording));
      const label =
        `Replay episode ${formatCount(recording.episode)}, return ${value}` +
        (recording.best ? ", the best" : "");
      const mark = element("button", { type: "button", "aria-label": label, title: label });
      mark.className = recording.best ? "mark best" : "mark";
      mark.addEventListener("click", (event) => {
        leaveAfterClick(mark, event);
        this.replay(recording);
      });
      this.marks.append(mark);
    }
  }

  private returnOf(recording: Recording): number | undefined {
    return this.report.returns[this.report.episode.indexOf(recording.episode)];
  }

  private placeMarks(plot: uPlot): void {
    if (this.marks.parentElement !== plot.over) plot.over.append(this.marks);
    const { min = 0, max = 0 } = plot.scales["x"] as uPlot.Scale;
    this.report.recordings.forEach((recording, i) => {
      const mark = this.marks.children[i] as HTMLElement;
      const value = this.returnOf(recording);
      mark.hidden = value === undefined || recording.episode < min || recording.episode > max;
      mark.style.left = `${plot.valToPos(recording.episode, "x")}px`;
      mark.style.top = `${plot.valToPos(value ?? 0, "y")}px`;
    });
  }

  private showValues(index: number | null): void {
    const { report } = this;
    if (index === null) {
      this.parts.readout.textContent = kHint;
      return;
    }
    const end = report.ends[report.endOf[index] ?? -1];
    const words = [
      `Episode ${formatCount(report.episode[index] ?? 0)}`,
      `return ${formatNumber(report.returns[index])}`,
      `mean ${formatNumber(this.mean[index])}`,
    ];
    if (end) words.push(end.reason ? `${end.kind}: ${end.reason}` : end.kind);
    this.parts.readout.textContent = words.join("  ·  ");
  }
}
