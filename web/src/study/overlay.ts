// One figure of all experiments from episode to episode: their means, and the intervals around them.

import { EpisodeChart } from "../charts/episode_chart.ts";
import { ExportButtons } from "../charts/export_buttons.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { element, onThemeChange } from "../page/dom.ts";
import type { Figure } from "./comparison.ts";
import type { Experiment } from "./data.ts";
import { colorOf } from "./words.ts";

const kOpacity = 0.16; // of the intervals, which lie upon each other
const kMostPoints = 500;

/** Episodes at which all of the curves can be shown, the last of each among them. */
export function commonEpisodes(curves: Float32Array[]): Float32Array {
  const all = [...new Set(curves.flatMap((episodes) => [...episodes]))].sort((a, b) => a - b);
  const stride = Math.ceil(all.length / kMostPoints);
  const ends = new Set(curves.map((episodes) => episodes.at(-1)));
  return Float32Array.from(all.filter((episode, i) => i % stride === 0 || ends.has(episode)));
}

/** `values` at `wanted`, between their own `episodes` linearly; NaN before and after them. */
export function valuesAt(
  wanted: Float32Array,
  episodes: Float32Array,
  values: Float32Array,
): Float32Array {
  let next = 0; // the first that is not before the wanted one
  return wanted.map((episode) => {
    while (next < episodes.length && (episodes[next] as number) < episode) ++next;
    const [after, value] = [episodes[next] ?? NaN, values[next] ?? NaN];
    if (after === episode || next === 0) return after === episode ? value : NaN;
    const [before, last] = [episodes[next - 1] as number, values[next - 1] as number];
    return last + ((value - last) * (episode - before)) / (after - before);
  });
}

export class Overlay {
  private readonly host = element("div", { class: "chart" });
  private readonly readout = element("p", { class: "readout", "aria-live": "polite" });
  private readonly hidden = new Set<number>(); // experiments
  private readonly episodes: Float32Array;
  private readonly switches: HTMLElement[];
  private means: Float32Array[] = []; // NaN everywhere for one that has no such figure
  private chart: EpisodeChart | undefined;

  constructor(
    private readonly experiments: Experiment[],
    host: HTMLElement,
  ) {
    this.episodes = commonEpisodes(experiments.map(({ curve }) => curve.episodes));
    this.switches = experiments.map((experiment, i) => this.switchOf(experiment, i));
    const legend = element("div", { class: "switches", role: "group", "aria-label": "Experiments" });
    legend.append(...this.switches);
    const exports = new ExportButtons("experiments", () => this.chart).element;
    host.append(legend, this.host, element("div", { class: "card-note" }, this.readout, exports));
    onThemeChange(() => this.chart?.redraw());
  }

  show(figure: Figure): void {
    this.chart?.destroy();
    const curves = this.experiments.map((experiment) => {
      const own = figure.curveIn(experiment);
      const at = (values: Float32Array | undefined): Float32Array =>
        valuesAt(this.episodes, experiment.curve.episodes, values ?? new Float32Array());
      const { name } = experiment;
      return { name, low: at(own?.low), high: at(own?.high), mean: at(own?.mean), isThere: own !== undefined };
    });
    this.means = curves.map(({ mean }) => mean);
    this.switches.forEach((each, i) => (each.hidden = !curves[i]?.isThere));
    const line = { kind: "line" as const, hasGaps: true };
    this.chart = new EpisodeChart(this.host, {
      episode: this.episodes,
      series: curves.flatMap(({ name, low, high, mean }, i) => [
        { ...line, name: `${name}, 95 % low`, values: low, color: "--none", width: 0 },
        { ...line, name: `${name}, 95 % high`, values: high, color: "--none", width: 0 },
        { ...line, name: `${name}, mean`, values: mean, color: colorOf(i), width: 2.25 },
      ]),
      bands: curves.map((_, i) => ({
        upper: 3 * i + 1,
        lower: 3 * i,
        color: colorOf(i),
        opacity: kOpacity,
      })),
      height: 300,
      sync: "comparison",
      label: `${figure.name} of each experiment, mean of its runs.`,
      onHover: (index) => this.showValues(index),
    });
    this.experiments.forEach((_, i) => this.apply(i));
    this.showValues(null);
  }

  /** Shows and hides an experiment. */
  private switchOf({ name }: Experiment, index: number): HTMLElement {
    const swatch = element("span", { class: "swatch", "aria-hidden": "true" });
    swatch.style.background = `var(${colorOf(index)})`;
    const made = element("button", { type: "button", "aria-pressed": "true" }, swatch, name);
    made.addEventListener("click", () => {
      if (!this.hidden.delete(index)) this.hidden.add(index);
      made.setAttribute("aria-pressed", String(!this.hidden.has(index)));
      this.apply(index);
    });
    return made;
  }

  private apply(experiment: number): void {
    for (let i = 0; i < 3; ++i) this.chart?.setVisible(3 * experiment + i, !this.hidden.has(experiment));
  }

  private showValues(index: number | null): void {
    if (index === null) {
      this.readout.textContent = "Lines are means of the runs, bands their 95 % confidence intervals.";
      return;
    }
    const words = this.experiments.flatMap(({ name }, i) => {
      const value = this.means[i]?.[index];
      return Number.isFinite(value) && !this.hidden.has(i) ? [`${name} ${formatNumber(value)}`] : [];
    });
    const episode = formatCount(this.episodes[index] ?? 0);
    this.readout.textContent = [`Episode ${episode}`, ...words].join("  ·  ");
  }
}
