// A small chart with its heading, as they stand side by side in the sections of values.

import { withUnit } from "../data/words.ts";
import type { Curve } from "../data/report_data.ts";
import { element } from "../page/dom.ts";

export interface ValueCard {
  chart: HTMLElement;
  value: HTMLElement; // at the heading's end
}

/** Adds a card to `host`; `note` stands below the heading. */
export function addValueCard(
  host: HTMLElement,
  { name, unit }: Pick<Curve, "name" | "unit">,
  note: string,
): ValueCard {
  const value = element("output", { class: "value" });
  const heading = element("h3", {}, withUnit({ name, unit }));
  const chart = element("div", { class: "chart" });
  const words = element("p", { class: "note" }, note);
  host.append(element("article", {}, element("header", {}, heading, value), words, chart));
  return { chart, value };
}
