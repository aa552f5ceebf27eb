// The curves of the runs that are chosen, and what they have in common.

import { EpisodeChart } from "../charts/episode_chart.ts";
import { ExportButtons } from "../charts/export_buttons.ts";
import { chartOfRuns } from "../charts/run_curves.ts";
import { seriesColor } from "../charts/series.ts";
import { decodeFloats } from "../data/base64.ts";
import { meanOfRuns, type MeanCurve } from "../data/mean_of_runs.ts";
import { kWindows, runningMean, usualWindow } from "../data/statistics.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { ask } from "../live/trainer.ts";
import { byId, element, onThemeChange } from "../page/dom.ts";
import { kindOf, type Run } from "./run.ts";

const kHint = "Point at the curves for their values; drag to zoom, double-click to see all.";
const kMostNamed = 4; // runs, in the words below the chart
const kNothing: MeanCurve = {
  mean: new Float32Array(),
  low: new Float32Array(),
  high: new Float32Array(),
};

interface Curve {
  returns: Float32Array;
  mean: Float32Array; // of as many episodes as is chosen
}

export class Comparison {
  private readonly section = byId("comparison", HTMLElement);
  private readonly host = byId("curves", HTMLElement);
  private readonly readout = byId("curves-readout", HTMLElement);
  private readonly select = byId("window", HTMLSelectElement);
  private readonly returns = new Map<string, Float32Array>();
  private chart: EpisodeChart | undefined;
  private chosen: Run[] = [];
  private curves: Curve[] = [];
  private common = kNothing;
  private isWindowChosen = false;

  constructor() {
    this.select.append(...kWindows.map((choice) => element("option", {}, String(choice))));
    this.select.addEventListener("change", () => {
      this.isWindowChosen = true;
      this.draw();
    });
    byId("curves-export", HTMLElement).append(new ExportButtons("runs", () => this.chart).element);
    onThemeChange(() => this.chart?.redraw());
  }

  /** Reads what is new of these runs, and draws them. */
  async show(runs: Run[]): Promise<void> {
    const isOther = runs.map(({ name }) => name).join("\n") !== this.chosen.map(({ name }) => name).join("\n");
    this.chosen = runs;
    const areNew = await Promise.all(runs.map((run) => this.read(run)));
    if (this.chosen === runs && (isOther || areNew.some(Boolean))) this.draw(isOther);
  }

  private async read({ name, episodes }: Run): Promise<boolean> {
    const known = this.returns.get(name) ?? new Float32Array();
    if (known.length === episodes) return false;
    // A run that went back to a checkpoint is read anew.
    const after = known.length < episodes ? known.length : 0;
    const part = await ask<{ after: number; returns: string }>(
      `curve?run=${encodeURIComponent(name)}&after=${after}`,
    );
    const added = decodeFloats(part.returns);
    const whole = new Float32Array(part.after + added.length);
    whole.set(known.subarray(0, part.after));
    whole.set(added, part.after);
    this.returns.set(name, whole);
    return true;
  }

  private draw(isOther = false): void {
    const length = Math.max(0, ...this.chosen.map(({ name }) => this.returns.get(name)?.length ?? 0));
    this.section.hidden = length === 0;
    if (length === 0) return;
    if (!this.isWindowChosen) this.select.value = String(usualWindow(length));
    const window = Number(this.select.value);
    this.curves = this.chosen.map(({ name }) => {
      const returns = this.returns.get(name) ?? new Float32Array();
      return { returns, mean: runningMean(returns, window) };
    });
    const areOfOneKind = new Set(this.chosen.map(kindOf)).size === 1;
    this.common = areOfOneKind ? meanOfRuns(this.curves.map(({ mean }) => mean)) : this.nothing(length);
    byId("kinds-note", HTMLElement).hidden = areOfOneKind;
    this.drawChart(Float32Array.from({ length }, (_, i) => i + 1), isOther);
    this.showKey(window, areOfOneKind);
    this.showValues(null);
  }

  private nothing(length: number): MeanCurve {
    const none = new Float32Array(length).fill(NaN);
    return { mean: none, low: none, high: none };
  }

  private drawChart(episode: Float32Array, isOther: boolean): void {
    const colored = this.curves.map(({ mean }, i) => ({
      name: this.chosen[i]?.name ?? "",
      values: mean,
      color: seriesColor(i),
    }));
    const options = chartOfRuns(episode, this.common, colored);
    if (this.chart && !isOther) {
      this.chart.extend(episode, options.series.map(({ values }) => values));
      return;
    }
    this.chart?.destroy();
    this.chart = new EpisodeChart(this.host, {
      ...options,
      height: 360,
      label: "Moving averages of the returns of the chosen runs, and their mean.",
      onHover: (index) => this.showValues(index),
    });
  }

  private showKey(window: number, hasMean: boolean): void {
    const dash = (color: string): HTMLElement => {
      const sign = element("span", { class: "dash" });
      sign.style.background = `var(${color})`;
      return sign;
    };
    const items = this.chosen.map(({ name }, i) => element("li", {}, dash(seriesColor(i)), name));
    if (hasMean && this.chosen.length > 1) {
      items.push(element("li", {}, dash("--ink"), "mean of the runs"));
      items.push(element("li", {}, element("span", { class: "block" }), "its 95 % confidence interval"));
    }
    byId("curves-key", HTMLElement).replaceChildren(...items);
    byId("window-words", HTMLElement).textContent = window === 1 ? "episode" : "episodes";
  }

  /** Each value of a few runs; of many, where they lie. */
  private runsInWords(index: number): string[] {
    const named = this.chosen.flatMap(({ name }, i) => {
      const value = this.curves[i]?.mean[index];
      return value !== undefined && Number.isFinite(value) ? [{ name, value }] : [];
    });
    if (named.length <= kMostNamed) return named.map(({ name, value }) => `${name} ${formatNumber(value)}`);
    const values = named.map(({ value }) => value);
    return [`${named.length} runs ${formatNumber(Math.min(...values))} … ${formatNumber(Math.max(...values))}`];
  }

  private showValues(index: number | null): void {
    if (index === null) {
      this.readout.textContent = kHint;
      return;
    }
    const words = [`Episode ${formatCount(index + 1)}`];
    const { mean, low, high } = this.common;
    if (this.chosen.length > 1 && Number.isFinite(mean[index])) {
      words.push(`mean ${formatNumber(mean[index])}`);
      if (Number.isFinite(low[index])) {
        words.push(`95 %: ${formatNumber(low[index])} … ${formatNumber(high[index])}`);
      }
    }
    words.push(...this.runsInWords(index));
    this.readout.textContent = words.join("  ·  ");
  }
}
