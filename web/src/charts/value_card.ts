// A small chart with its heading, as they stand side by side in the sections of values.

import { withUnit } from "../data/words.ts";
import type { Curve } from "../data/report_data.ts";
import { element, readout } from "../page/dom.ts";
import type { EpisodeChart } from "./episode_chart.ts";
import { ExportButtons } from "./export_buttons.ts";

export interface ValueCard {
  chart: HTMLElement;
  value: HTMLElement; // at the heading's end
}

/** Adds a card to `host`; `note` stands below the heading. `chartOf`: what is in the card's chart. */
export function addValueCard(
  host: HTMLElement,
  { name, unit }: Pick<Curve, "name" | "unit">,
  note: string,
  chartOf: () => EpisodeChart | undefined,
): ValueCard {
  const value = readout({ class: "value" });
  const heading = element("h3", {}, withUnit({ name, unit }));
  const chart = element("div", { class: "chart" });
  const exports = new ExportButtons(name, chartOf).element;
  const words = element("div", { class: "card-note" }, element("p", { class: "note" }, note), exports);
  host.append(element("article", {}, element("header", {}, heading, value), words, chart));
  return { chart, value };
}
