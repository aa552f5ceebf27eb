// What a task says, as `taskc doc` writes it: equations, tables, phases; and what the run makes of
// the equations at each moment.

import katex from "katex";

import { element } from "../../page/dom.ts";
import { row, table } from "../../page/table.ts";
import { kPayWindow, type Entry } from "../history.ts";
import { Lets, type KnownNumbers, type LetWorth } from "./lets.ts";
import { presentOf, rateOf, sumOf, type Present, type PresentTask } from "./present.ts";

export interface Piece {
  face: "plain" | "code" | "math" | "strong";
  text: string;
}
export interface FormulaLine {
  left: string; // LaTeX, as the sign and what is to the right
  sign: string;
  right: string;
  term?: string; // the reward term that is paid this
  reads?: string[]; // names in it
  let?: string; // whose value this is
}
type Block =
  | { kind: "heading"; level: number; text: Piece[] }
  | { kind: "paragraph"; text: Piece[] }
  | { kind: "formulas"; lines: FormulaLine[] }
  | { kind: "table"; header: string[]; rows: Piece[][][] }
  | { kind: "list"; items: Piece[][] }
  | { kind: "automaton"; phases: string[]; ways: { from: string; to: string; labels: string[] }[] };

/** The result of the request `task/page` (docs/editors.md). */
export interface TaskPage {
  title: string;
  blocks: Block[];
}

/** Elements, styled one by one: markup with styles in it would be refused by the page's policy. */
function typeset(latex: string, displayMode: boolean): HTMLElement {
  // On a phone an equation is wider than the page: it is scrolled, by keys, too.
  const host = displayMode
    ? element("div", { class: "math", tabindex: "0" })
    : element("span", { class: "math" });
  katex.render(latex, host, { displayMode, throwOnError: false });
  return host;
}

function pieceToDom({ face, text }: Piece): Node | string {
  switch (face) {
    case "plain":
      return text;
    case "code":
      return element("code", {}, text);
    case "math":
      return typeset(text, false);
    case "strong":
      return element("strong", {}, text);
  }
}

const inline = (pieces: Piece[]): HTMLElement => element("span", {}, ...pieces.map(pieceToDom));

/** A number of the run, and where it stands in the page. */
interface Readout {
  present: Present;
  output: Text;
}

export class TaskPageView {
  private page: TaskPage | undefined;
  private task: PresentTask | undefined;
  private readouts: Readout[] = [];
  private readonly lets: Lets;

  /** `askLets`: what the lets of the text are worth; null where that cannot be known. */
  constructor(
    private readonly host: HTMLElement,
    askLets: (known: KnownNumbers) => Promise<LetWorth[] | null>,
  ) {
    this.lets = new Lets(askLets, () => this.draw());
  }

  show(page: TaskPage): void {
    this.page = page;
    this.draw();
  }

  /** Whose numbers are shown from now on. */
  setTask(task: PresentTask): void {
    this.task = task;
    this.draw();
  }

  /** The numbers at a moment; the page stays as it is. */
  update(entry: Entry): void {
    for (const { present, output } of this.readouts) {
      const words = present.at(entry);
      if (output.data !== words) output.data = words;
    }
    if (this.task && this.hasLets) void this.lets.update(entry, this.task);
  }

  private get hasLets(): boolean {
    const blocks = this.page?.blocks ?? [];
    return blocks.some((block) => block.kind === "formulas" && block.lines.some((line) => line.let !== undefined));
  }

  /** Scrolled to where it was. */
  private draw(): void {
    const { scrollTop } = this.host;
    this.readouts = [];
    this.host.replaceChildren(...(this.page?.blocks ?? []).map((block) => this.blockToDom(block)));
    this.host.scrollTop = scrollTop;
  }

  private blockToDom(block: Block): HTMLElement {
    switch (block.kind) {
      case "heading":
        return element(block.level <= 2 ? "h3" : "h4", {}, inline(block.text));
      case "paragraph":
        return element("p", {}, inline(block.text));
      case "formulas":
        return this.formulasToDom(block.lines);
      case "table":
        return table(block.header, block.rows.map((cells) => row(cells.map(inline))));
      case "list":
        return element("ul", {}, ...block.items.map((item) => element("li", {}, inline(item))));
      case "automaton":
        return element(
          "ul",
          { class: "ways" },
          ...block.ways.map(({ from, to, labels }) =>
            element("li", {}, element("strong", {}, `${from} → ${to}`), ` ${labels.join("; ")}`),
          ),
        );
    }
  }

  private formulasToDom(lines: FormulaLine[]): HTMLElement {
    const equations = lines.map((line) => {
      const left = typeset(line.left, false);
      left.classList.add("left");
      const right = typeset(`{} ${line.sign} ${line.right}`, true);
      return element("div", { class: "equation" }, left, right, ...this.presentIn(line));
    });
    return element("div", { class: "formulas" }, ...equations);
  }

  /** What is known of a line: what its term pays or its let is worth, and what it reads. */
  private presentIn({ term, reads = [], let: name }: FormulaLine): HTMLElement[] {
    const { task } = this;
    if (!task) return [];
    const paid: [string, Present | undefined][] =
      term === undefined ? [] : [[`pays, over ${kPayWindow} s`, rateOf(term, task)], ["in the episode", sumOf(term, task)]];
    const read = reads.map((each): [string, Present | undefined] => [
      each,
      presentOf(each, task) ?? this.lets.presentOf(each),
    ]);
    const worth = name === undefined ? undefined : this.lets.presentOf(name);
    const items = [
      ...paid.map(([words, present]) => this.readout(words, present, { "data-term": term ?? "" })),
      this.readout("is", worth, { "data-let": name ?? "" }),
      ...read.map(([each, present]) => this.readout(element("code", {}, each), present, { "data-read": each })),
    ].flat();
    return items.length > 0 ? [element("dl", { class: "present" }, ...items)] : [];
  }

  private readout(
    name: string | Node,
    present: Present | undefined,
    attributes: Record<string, string>,
  ): HTMLElement[] {
    if (!present) return [];
    const output = new Text("–");
    const value = element("span", { class: "value" }, output);
    value.style.minWidth = `${present.width}ch`;
    const unit = element("span", { class: "unit" }, present.unit);
    this.readouts.push({ present, output });
    return [element("div", attributes, element("dt", {}, name), element("dd", {}, value, " ", unit))];
  }
}
