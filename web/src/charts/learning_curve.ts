// The return of each episode, its running mean, what shadows say of it, a mark for each episode
// that can be replayed, and one for each change.

import type uPlot from "uplot";

import type { Recording, Report } from "../data/report_data.ts";
import { runningMean, runningMeanWhereThere } from "../data/statistics.ts";
import { versionStarts } from "../data/versions.ts";
import { endInWords, formatCount, formatNumber } from "../data/words.ts";
import { element, leaveAfterClick, onThemeChange } from "../page/dom.ts";
import { ChangeMarks } from "./change_marks.ts";
import { EpisodeChart } from "./episode_chart.ts";
import { ExportButtons } from "./export_buttons.ts";
import { shadowColor } from "./series.ts";

const kHint = "Point at an episode for its values; drag to zoom, double-click to see all.";

export class LearningCurve {
  private readonly chart: EpisodeChart;
  private readonly marks = element("div", { class: "marks" });
  private readonly changes: ChangeMarks;
  private mean: Float32Array;
  private shadowMeans: Float32Array[];
  private wasRead: Recording | undefined; // by the last tap

  constructor(
    private readonly report: Report,
    private readonly parts: Record<"chart" | "readout" | "key" | "exports", HTMLElement>,
    window: number,
    private readonly replay: (recording: Recording) => void,
  ) {
    this.mean = this.meanOf(report.returns, window);
    this.shadowMeans = this.shadowMeansOf(window);
    this.changes = new ChangeMarks(report.changes);
    this.makeMarks();
    this.fillKey();
    const starts = versionStarts(report);
    this.chart = new EpisodeChart(parts.chart, {
      episode: report.episode,
      series: [
        { name: "return", values: report.returns, color: "--point", kind: "points" },
        { name: "mean", values: this.mean, color: "--accent", kind: "line", hasGaps: true, starts },
        ...this.shadowMeans.map((values, i) => ({
          name: `${report.shadows[i]?.module ?? ""}, mean`,
          values,
          color: shadowColor(i),
          kind: "line" as const,
          hasGaps: true,
        })),
      ],
      height: 386,
      label:
        "Return of each episode and its running mean. The arrow keys move from one to the next.",
      onHover: (index) => this.showValues(index),
      onDraw: (plot) => {
        this.changes.place(plot);
        this.placeMarks(plot);
      },
    });
    parts.exports.append(new ExportButtons("returns", () => this.chart).element);
    onThemeChange(() => this.chart.redraw());
    this.showValues(null);
  }

  setWindow(window: number): void {
    this.mean = this.meanOf(this.report.returns, window);
    this.shadowMeans = this.shadowMeansOf(window);
    [this.mean, ...this.shadowMeans].forEach((values, i) => this.chart.setValues(i + 1, values));
    this.showValues(null);
  }

  /** Shows which recording is being replayed. */
  select(recording: Recording): void {
    this.report.recordings.forEach((other, i) => {
      this.marks.children[i]?.setAttribute("aria-pressed", String(other === recording));
    });
  }

  /** Begins anew with each task: returns of two tasks have no mean. */
  private meanOf(returns: Float32Array, window: number): Float32Array {
    return runningMean(returns, window, versionStarts(this.report));
  }

  private shadowMeansOf(window: number): Float32Array[] {
    return this.report.shadows.map(({ values }) => runningMeanWhereThere(values, window));
  }

  private fillKey(): void {
    this.report.shadows.forEach(({ module, tasks }, i) => {
      const dash = element("span", { class: "dash" });
      dash.style.background = `var(${shadowColor(i)})`;
      const names = new Set(tasks.map((task) => this.report.tasks[task]?.name));
      const words = `shadow ${module} (${[...names].join(", ")}), running mean`;
      this.parts.key.append(element("li", {}, dash, words));
    });
    if (this.report.changes.length === 0) return;
    this.parts.key.append(element("li", {}, element("span", { class: "bar-mark" }), "change"));
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
        const isTouch = event instanceof PointerEvent && event.pointerType === "touch";
        if (isTouch && this.wasRead !== recording) this.read(recording);
        else this.replay(recording);
      });
      this.marks.append(mark);
    }
  }

  /** Without a mouse to point with, the first tap says what the second one replays. */
  private read(recording: Recording): void {
    this.chart.pointAt(this.report.episode.indexOf(recording.episode));
    this.wasRead = recording;
    const replay = element("button", { type: "button", class: "text" }, "replay");
    replay.addEventListener("click", () => this.replay(recording));
    this.parts.readout.append("  ·  ", replay);
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
    this.wasRead = undefined;
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
    report.shadows.forEach(({ module, values }) => {
      if (Number.isFinite(values[index])) words.push(`${module} ${formatNumber(values[index])}`);
    });
    if (end) words.push(endInWords(end));
    this.parts.readout.textContent = words.join("  ·  ");
  }
}
