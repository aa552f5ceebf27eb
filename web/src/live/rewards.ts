// What each reward term pays at this moment, and has paid so far.

import { formatNumber } from "../data/words.ts";
import { element, readout } from "../page/dom.ts";
import { kPayWindow, type Entry, type History } from "./history.ts";
import { Trace } from "./trace.ts";
import type { Layout, ViewValue } from "./view_frames.ts";

const kFading = 0.98; // of the bars' common scale, from frame to frame

interface Row {
  term: ViewValue;
  bar: HTMLElement;
  rate: HTMLElement;
  action: HTMLElement;
  sum: HTMLElement;
  trace: Trace;
}

export class Rewards {
  private rows: Row[] = [];
  private shadows: { value: ViewValue; sum: HTMLElement }[] = [];
  private total: HTMLElement | undefined;
  private greatest = 0;

  constructor(private readonly host: HTMLElement) {}

  show(layout: Layout): void {
    const terms = layout.values.filter(({ kind }) => kind === "term");
    const shadows = layout.values.filter(({ kind }) => kind === "shadow");
    this.greatest = 0;
    this.total = readout({ class: "sum" });
    this.rows = terms.map((term) => this.makeRow(term));
    this.shadows = shadows.map((value) => ({ value, sum: readout({ class: "sum" }) }));
    const body = element("tbody");
    for (const row of this.rows) body.append(this.rowElement(row));
    const foot = element("tfoot", {}, this.sumRow("return", layout.task, "what the learner is paid", this.total));
    for (const { value, sum } of this.shadows) {
      foot.append(this.sumRow(value.name, value.name, "shadow, same motion", sum));
    }
    this.host.replaceChildren(element("table", { class: "rewards-table" }, this.head(), body, foot));
  }

  update({ last }: History): void {
    if (!last) return;
    const { frame, rates } = last;
    const rateOf = (term: ViewValue): number => rates.get(term) ?? 0;
    const now = Math.max(0, ...this.rows.map(({ term }) => Math.abs(rateOf(term))));
    this.greatest = Math.max(now, this.greatest * kFading, 1e-12);
    for (const row of this.rows) {
      const rate = rateOf(row.term);
      const share = Math.min(1, Math.abs(rate) / this.greatest);
      row.bar.style.setProperty("--share", `${50 * share}%`);
      row.bar.dataset["sign"] = rate < 0 ? "minus" : "plus";
      row.rate.textContent = formatNumber(rate);
      row.action.textContent = formatNumber(last.ofAction.get(row.term));
      row.sum.textContent = formatNumber(frame.number(row.term.first));
    }
    for (const { value, sum } of this.shadows) {
      sum.textContent = formatNumber(frame.number(value.first));
    }
    if (this.total) this.total.textContent = formatNumber(frame.return);
  }

  drawTraces({ entries }: History): void {
    for (const { trace } of this.rows) trace.draw(entries);
  }

  /** How strongly the term pays, from -1 to 1 of what the most generous one has paid lately. */
  share(entry: Entry, term: ViewValue): number {
    return this.greatest > 0 ? (entry.rates.get(term) ?? 0) / this.greatest : 0;
  }

  private makeRow(term: ViewValue): Row {
    return {
      term,
      bar: element("span", { class: "pay", "aria-hidden": "true" }, element("span")),
      rate: readout(),
      action: readout(),
      sum: readout({ class: "sum" }),
      trace: new Trace(1, (entry) => entry.rates.get(term) ?? NaN),
    };
  }

  private head(): HTMLElement {
    const cell = (words: string, title: string): HTMLElement =>
      element("th", { scope: "col", title }, words);
    return element(
      "thead",
      {},
      element(
        "tr",
        {},
        cell("term", "of the task"),
        cell("now", `what the term pays, as a rate over the last ${kPayWindow} s`),
        cell("per s", "the same as a number"),
        cell("last seconds", "the same over the frames that were shown"),
        cell("action", "what the term has paid since the present action began"),
        cell("episode", "what the term has paid in this episode"),
      ),
    );
  }

  private rowElement({ term, bar, rate, action, sum, trace }: Row): HTMLElement {
    const name = element("th", { scope: "row", title: term.doc }, term.name);
    const cells = [bar, rate, trace.canvas, action, sum].map((part) => element("td", {}, part));
    return element("tr", { "data-term": term.name }, name, ...cells);
  }

  private sumRow(name: string, of: string, words: string, sum: HTMLElement): HTMLElement {
    return element(
      "tr",
      { "data-sum-of": of },
      element("th", { scope: "row" }, name),
      element("td", { colspan: "2" }, words),
      element("td"), // of the columns that a phone has no room for
      element("td"),
      element("td", {}, sum),
    );
  }
}
