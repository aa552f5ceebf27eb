// A key figure: its name, its value in large type, and what is to be known about it.

import { element } from "./dom.ts";

export const figure = (name: string, value: string, note: string): HTMLElement =>
  element(
    "div",
    { class: "figure" },
    element("dt", {}, name),
    element("dd", { class: "number" }, value),
    element("dd", { class: "note" }, note),
  );
