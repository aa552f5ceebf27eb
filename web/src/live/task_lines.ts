// The text of the task that pays now. A line lights up while its term pays.

import type { Source } from "../data/report_data.ts";
import { element } from "../page/dom.ts";
import { sourceCode } from "../page/source.ts";
import type { Layout, ViewValue } from "./view_frames.ts";

const kAbove = 60; // the first line that pays is seen with what stands before it [px]

export class TaskLines {
  private terms: { term: ViewValue; line: HTMLElement }[] = [];

  constructor(private readonly host: HTMLElement) {}

  show(sources: Source[], layout: Layout): void {
    const codes = sources.map(({ text }) => sourceCode(text));
    const terms = layout.values.filter(({ kind }) => kind === "term");
    this.terms = [];
    for (const term of terms) {
      const line = codes[term.source ?? -1]?.children[(term.line ?? 0) - 1];
      if (!(line instanceof HTMLElement)) continue;
      line.classList.add("pays");
      line.title = term.name;
      this.terms.push({ term, line });
    }
    const texts = codes.map((code, i) => {
      const file = sources[i]?.file ?? "";
      return element(
        "details",
        i === 0 ? { open: "" } : {},
        element("summary", {}, file),
        element("pre", { class: "source" }, code),
      );
    });
    this.host.replaceChildren(...texts);
    const first = this.terms[0]?.line;
    if (first) this.host.scrollTop = first.offsetTop - kAbove;
  }

  /** `shareOf`: how strongly a term pays, from -1 to 1. */
  light(shareOf: (term: ViewValue) => number): void {
    for (const { term, line } of this.terms) {
      const share = shareOf(term);
      line.style.setProperty("--lit", `${Math.round(100 * Math.min(1, Math.abs(share)))}%`);
      line.dataset["sign"] = share < 0 ? "minus" : "plus";
    }
  }
}
