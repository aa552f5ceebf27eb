// All that the task reads, remembers and measures, as numbers with traces; and its phases.

import { formatNumber } from "../data/words.ts";
import { byId, element, readout } from "../page/dom.ts";
import type { History } from "./history.ts";
import { Trace } from "./trace.ts";
import { valueInWords } from "./value_words.ts";
import type { Frame, Layout, ViewValue } from "./view_frames.ts";

const kGroups: [ViewValue["kind"], string][] = [
  ["metric", "Metrics"],
  ["goal", "Goals"],
  ["memory", "Memory"],
  ["sensor", "Sensors"],
  ["log", "Logs"],
];

/** What the compiler remembers on behalf of the task, such as for `once`. */
const isHidden = ({ name }: ViewValue): boolean => name.includes("#");

interface Row {
  value: ViewValue;
  output: HTMLElement;
  trace: Trace;
  elements: HTMLElement[]; // one for each number where there are many
  details: HTMLDetailsElement | undefined;
}

export class Values {
  private rows: Row[] = [];
  private phase: ViewValue | undefined;
  private readonly phases = byId("phases", HTMLElement);
  private chips: { chip: HTMLElement; time: HTMLElement }[] = [];

  constructor(private readonly host: HTMLElement) {}

  show(layout: Layout): void {
    this.rows = [];
    const groups = kGroups.map(([kind, name]) => {
      const values = layout.values.filter((value) => value.kind === kind && !isHidden(value));
      if (values.length === 0) return "";
      const rows = values.map((value) => this.makeRow(value));
      return element("div", { class: "value-group" }, element("h3", {}, name), ...rows);
    });
    this.host.replaceChildren(...groups.filter((group) => group !== ""));
    this.showPhases(layout);
  }

  update({ last }: History): void {
    if (!last) return;
    for (const { value, output, elements, details } of this.rows) {
      const numbers = last.frame.valuesOf(value);
      output.textContent = valueInWords(value, numbers);
      if (!details?.open) continue;
      elements.forEach((element, i) => (element.textContent = formatNumber(numbers[i])));
    }
    this.updatePhases(last.frame);
  }

  drawTraces({ entries }: History): void {
    for (const { trace } of this.rows) trace.draw(entries);
  }

  private makeRow(value: ViewValue): HTMLElement {
    const output = readout();
    const trace = new Trace(value.size, ({ frame }, line) => frame.number(value.first + line));
    const name = element("span", { class: "name" }, value.name);
    if (value.unit) name.append(" ", element("span", { class: "unit" }, value.unit));
    const head = [name, output, trace.canvas];
    const words = [value.type, value.doc].filter(Boolean).join(": ");
    if (!value.elements) {
      this.rows.push({ value, output, trace, elements: [], details: undefined });
      return element("div", { class: "value-row", title: words, "data-value": value.name }, ...head);
    }
    const elements = value.elements.map(() => readout());
    const list = value.elements.map((each, i) =>
      element("div", {}, element("dt", {}, each), element("dd", {}, elements[i] as HTMLElement)),
    );
    const details = element(
      "details",
      { class: "value-row", title: words, "data-value": value.name },
      element("summary", {}, ...head),
      element("dl", { class: "elements" }, ...list),
    );
    this.rows.push({ value, output, trace, elements, details });
    return details;
  }

  private showPhases(layout: Layout): void {
    this.phase = layout.values.find(({ kind }) => kind === "phase");
    this.phases.hidden = !this.phase;
    this.chips = (this.phase?.phases ?? []).map(({ name, doc }) => {
      const time = element("span", { class: "time" });
      return { chip: element("span", { class: "phase", title: doc }, name, time), time };
    });
    this.phases.replaceChildren("phase ", ...this.chips.map(({ chip }) => chip));
  }

  private updatePhases(frame: Frame): void {
    if (!this.phase) return;
    const [present = -1, time = 0] = frame.valuesOf(this.phase);
    this.chips.forEach((parts, i) => {
      parts.chip.toggleAttribute("data-present", i === present);
      parts.time.textContent = i === present ? ` ${time.toFixed(1)} s` : "";
    });
  }
}
