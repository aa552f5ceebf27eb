// Experiments compared: one figure of all of them, each mean with its interval on a common axis and
// from episode to episode, and what their reward terms paid.

import { interval, mean, type Estimate } from "../data/estimate.ts";
import { formatTick, withUnit } from "../data/words.ts";
import { element } from "../page/dom.ts";
import { row, table } from "../page/table.ts";
import type { Experiment, Means } from "./data.ts";
import { idOf } from "./experiment.ts";
import { Overlay } from "./overlay.ts";
import { colorOf } from "./words.ts";

type Compared = Pick<
  Experiment,
  "final_return" | "metrics" | "terms" | "curve" | "metricCurves" | "termCurves"
>;

/** Something that experiments can have a value of. */
export interface Figure {
  name: string;
  kind: "return" | "metric" | "term";
  valueIn: (experiment: Compared) => Estimate | undefined; // at the end
  curveIn: (experiment: Compared) => Means | undefined; // at the episodes of its curve
}

const kByTerm = "return by ";

/** The return, then the metrics and the terms that at least two of the experiments have. */
export function figuresOf(experiments: Compared[]): Figure[] {
  const metrics = experiments.flatMap((experiment) => experiment.metrics.map(withUnit));
  const terms = experiments.flatMap((experiment) => experiment.terms.map(({ name }) => name));
  const figures: Figure[] = [
    {
      name: "return",
      kind: "return",
      valueIn: ({ final_return }) => final_return,
      curveIn: ({ curve }) => curve,
    },
    ...[...new Set(metrics)].map((name): Figure => ({
      name,
      kind: "metric",
      valueIn: (experiment) =>
        experiment.metrics.find((metric) => withUnit(metric) === name)?.value,
      curveIn: (experiment) =>
        experiment.metricCurves.find((metric) => withUnit(metric) === name),
    })),
    ...[...new Set(terms)].map((name): Figure => ({
      name: kByTerm + name,
      kind: "term",
      valueIn: (experiment) => experiment.terms.find((term) => term.name === name)?.value,
      curveIn: (experiment) => experiment.termCurves.find((term) => term.name === name),
    })),
  ];
  const isCompared = ({ valueIn }: Figure): boolean =>
    experiments.filter((experiment) => (valueIn(experiment)?.mean ?? null) !== null).length > 1;
  return figures.filter(isCompared);
}

/** What the axis reaches, to have all means and intervals, and 0. */
export function axisOf(values: Estimate[]): [number, number] {
  const ends = values.flatMap((value) => [value.mean, value.low, value.high]);
  const numbers = [0, ...ends.filter((end): end is number => end !== null)];
  const [low, high] = [Math.min(...numbers), Math.max(...numbers)];
  return low === high ? [low, low + 1] : [low, high];
}

function plotOf(
  { mean: middle, low, high }: Estimate,
  axis: [number, number],
  experiment: number,
): HTMLElement {
  const at = (value: number): string => `${(100 * (value - axis[0])) / (axis[1] - axis[0])}%`;
  const plot = element("div", { class: "interval", "aria-hidden": "true" });
  plot.style.setProperty("--color", `var(${colorOf(experiment)})`);
  const zero = element("span", { class: "zero" });
  zero.style.left = at(0);
  plot.append(zero);
  if (low !== null && high !== null) {
    const band = element("span", { class: "band" });
    band.style.left = at(low);
    band.style.width = `calc(${at(high)} - ${at(low)})`;
    plot.append(band);
  }
  if (middle !== null) {
    const dot = element("span", { class: "dot" });
    dot.style.left = at(middle);
    plot.append(dot);
  }
  return plot;
}

const nameOf = (experiment: Experiment, index: number): HTMLElement =>
  element("a", { href: `#${idOf(index)}` }, experiment.name);

const axisRow = (axis: [number, number]): HTMLElement =>
  element("div", { class: "ends-of-axis" }, ...axis.map((end) => element("span", {}, formatTick(end))));

function tableOf(experiments: Experiment[], { valueIn }: Figure): HTMLElement {
  const values = experiments.map(valueIn);
  const axis = axisOf(values.filter((value) => value !== undefined));
  const rows = experiments.flatMap((experiment, i) => {
    const value = values[i];
    if (!value) return [];
    return [row([nameOf(experiment, i), plotOf(value, axis, i), mean(value), interval(value)])];
  });
  rows.push(row(["", axisRow(axis), "", ""]));
  return table(["Experiment", "", "At the end", "95 %"], rows);
}

/** All terms on one axis: of each the experiments below each other. */
function termsOf(experiments: Experiment[], figures: Figure[]): HTMLElement {
  const all = figures.flatMap(({ valueIn }) => experiments.map(valueIn));
  const axis = axisOf(all.filter((value) => value !== undefined));
  const rowsOf = ({ name, valueIn }: Figure): HTMLTableRowElement[] => {
    const rows = experiments.flatMap((experiment, i) => {
      const value = valueIn(experiment);
      if (!value) return [];
      const plot = plotOf(value, axis, i);
      return [row(["", nameOf(experiment, i), plot, mean(value), interval(value)])];
    });
    if (rows[0]?.cells[0]) rows[0].cells[0].textContent = name.replace(kByTerm, "");
    for (const next of rows.slice(1)) next.classList.add("same-term");
    return rows;
  };
  const last = row(["", "", axisRow(axis), "", ""]);
  return table(["Term", "Experiment", "", "Per episode", "95 %"], [...figures.flatMap(rowsOf), last]);
}

/** Shows nothing of a study of one experiment. */
export function showComparison(experiments: Experiment[], host: HTMLElement): void {
  const figures = figuresOf(experiments);
  host.hidden = figures.length === 0;
  if (host.hidden) return;
  const select = element("select", { id: "compared" });
  select.append(...figures.map(({ name }) => element("option", {}, name)));
  const label = element("label", {}, "the ", select);
  const heading = element("h2", { id: "comparison-heading" }, "Compared");
  const place = element("div", { class: "comparison" });
  const curves = element("div", { class: "overlay" });
  host.append(element("header", { class: "section-head" }, heading, label));
  host.append(element("div", { class: "first-row" }, curves, place));
  const overlay = new Overlay(experiments, curves);
  const show = (): void => {
    const figure = figures[select.selectedIndex];
    if (!figure) return;
    place.replaceChildren(tableOf(experiments, figure));
    overlay.show(figure);
  };
  select.addEventListener("change", show);
  const terms = figures.filter(({ kind }) => kind === "term");
  if (terms.length > 0) {
    host.append(
      element("h3", {}, "Return by reward term"),
      element("div", { class: "comparison side-by-side" }, termsOf(experiments, terms)),
    );
  }
  show();
}
