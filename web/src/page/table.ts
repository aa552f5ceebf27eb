// Tables with a head.

import { element } from "./dom.ts";

type Content = string | Node;

export const row = (cells: Content[]): HTMLTableRowElement =>
  element("tr", {}, ...cells.map((content) => element("td", {}, content)));

/** A narrow page scrolls it, by keys, too. */
export function table(heads: string[], rows: HTMLElement[]): HTMLElement {
  const head = element("tr", {}, ...heads.map((text) => element("th", { scope: "col" }, text)));
  return element(
    "div",
    { class: "scroll", tabindex: "0" },
    element("table", { class: "list" }, element("thead", {}, head), element("tbody", {}, ...rows)),
  );
}
