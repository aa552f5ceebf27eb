// One figure of all experiments side by side, each mean with its interval on a common axis.

import { interval, mean, type Estimate } from "../data/estimate.ts";
import { formatTick } from "../data/words.ts";
import { element } from "../page/dom.ts";
import { row, table } from "../page/table.ts";
import type { Experiment } from "./data.ts";
import { idOf } from "./experiment.ts";

type Compared = Pick<Experiment, "final_return" | "metrics" | "terms">;

/** Something that experiments can have a value of. */
export interface Figure {
  name: string;
  valueIn: (experiment: Compared) => Estimate | undefined;
}

const withUnit = ({ name, unit }: { name: string; unit: string }): string =>
  unit ? `${name} [${unit}]` : name;

/** The return, then the metrics and the terms that at least two of the experiments have. */
export function figuresOf(experiments: Compared[]): Figure[] {
  const metrics = experiments.flatMap((experiment) => experiment.metrics.map(withUnit));
  const terms = experiments.flatMap((experiment) => experiment.terms.map(({ name }) => name));
  const figures: Figure[] = [
    { name: "final return", valueIn: ({ final_return }) => final_return },
    ...[...new Set(metrics)].map((name) => ({
      name,
      valueIn: (experiment: Compared) =>
        experiment.metrics.find((metric) => withUnit(metric) === name)?.value,
    })),
    ...[...new Set(terms)].map((name) => ({
      name: `return by ${name}`,
      valueIn: (experiment: Compared) =>
        experiment.terms.find((term) => term.name === name)?.value,
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

function plotOf({ mean: middle, low, high }: Estimate, axis: [number, number]): HTMLElement {
  const at = (value: number): string => `${(100 * (value - axis[0])) / (axis[1] - axis[0])}%`;
  const plot = element("div", { class: "interval", "aria-hidden": "true" });
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

function tableOf(experiments: Experiment[], { valueIn }: Figure): HTMLElement {
  const values = experiments.map(valueIn);
  const axis = axisOf(values.filter((value) => value !== undefined));
  const ends = axis.map((end) => element("span", {}, formatTick(end)));
  const rows = experiments.flatMap((experiment, i) => {
    const value = values[i];
    if (!value) return [];
    const name = element("a", { href: `#${idOf(i)}` }, experiment.name);
    return [row([name, plotOf(value, axis), mean(value), interval(value)])];
  });
  rows.push(row(["", element("div", { class: "ends-of-axis" }, ...ends), "", ""]));
  return table(["Experiment", "", "Mean", "95 %"], rows);
}

/** Shows nothing of a study of one experiment. */
export function showComparison(experiments: Experiment[], host: HTMLElement): void {
  const figures = figuresOf(experiments);
  host.hidden = figures.length === 0;
  if (host.hidden) return;
  const select = element("select", { id: "compared" });
  select.append(...figures.map(({ name }) => element("option", {}, name)));
  const label = element("label", {}, "of the ", select);
  const heading = element("h2", { id: "comparison-heading" }, "Compared");
  const place = element("div", { class: "comparison" });
  const show = (): void => {
    const figure = figures[select.selectedIndex];
    if (figure) place.replaceChildren(tableOf(experiments, figure));
  };
  select.addEventListener("change", show);
  host.append(element("header", { class: "section-head" }, heading, label), place);
  show();
}
