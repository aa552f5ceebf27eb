// The task's text, in which those lines are lit that pay at the moment.

import type { Task } from "../data/report_data.ts";
import { rewardLines } from "../data/task_source.ts";
import type { Timeline } from "../data/timeline.ts";
import { element } from "../page/dom.ts";
import { sourceCode } from "../page/source.ts";
import { formatPaid, termColor } from "./rows.ts";

interface LitLine {
  term: number; // index
  row: HTMLElement;
}

const kLeast = 0.12; // opacity of what pays nearly nothing
const kMost = 0.42;

export class LitSource {
  private lines: LitLine[] = [];
  private most: number[] = []; // that each term pays at a time

  constructor(private readonly host: HTMLElement) {}

  show(task: Task | undefined, timeline: Timeline): void {
    const sources = task?.sources ?? [];
    const found = rewardLines(sources.map(({ text }) => text));
    this.most = timeline.terms.map(({ paid }) =>
      paid.reduce((most, value) => Math.max(most, Math.abs(value)), 0),
    );
    this.lines = [];
    this.host.replaceChildren();
    sources.forEach(({ file, text }, source) => {
      const here = found.filter((each) => each.source === source);
      if (here.length === 0) return;
      const code = sourceCode(text);
      for (const { line, term } of here) {
        const index = timeline.terms.findIndex(({ name }) => name === term);
        const row = code.children[line];
        if (index < 0 || !(row instanceof HTMLElement)) continue;
        row.classList.add("pays");
        row.style.setProperty("--term", `var(${termColor(index)})`);
        this.lines.push({ term: index, row });
      }
      const name = element("p", { class: "note" }, file);
      this.host.append(name, element("pre", { class: "source" }, code));
    });
    this.host.hidden = this.lines.length === 0;
    const first = this.lines[0]?.row;
    this.host.scrollTop = first ? first.offsetTop - 24 : 0;
  }

  setSample(timeline: Timeline, sample: number): void {
    for (const { term, row } of this.lines) {
      const paid = timeline.terms[term]?.paid[sample] ?? 0;
      row.classList.toggle("lit", paid !== 0);
      const part = Math.abs(paid) / (this.most[term] || 1);
      row.style.setProperty("--light", `${100 * (kLeast + (kMost - kLeast) * part)}%`);
      row.dataset["paid"] = paid === 0 ? "" : formatPaid(paid);
    }
  }
}
