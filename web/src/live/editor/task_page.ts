// What a task says, as `taskc doc` writes it: equations, tables, phases.

import katex from "katex";

import { element } from "../../page/dom.ts";
import { row, table } from "../../page/table.ts";

export interface Piece {
  face: "plain" | "code" | "math" | "strong";
  text: string;
}
type Block =
  | { kind: "heading"; level: number; text: Piece[] }
  | { kind: "paragraph"; text: Piece[] }
  | { kind: "formulas"; latex: string }
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

function blockToDom(block: Block): HTMLElement {
  switch (block.kind) {
    case "heading":
      return element(block.level <= 2 ? "h3" : "h4", {}, inline(block.text));
    case "paragraph":
      return element("p", {}, inline(block.text));
    case "formulas":
      return typeset(block.latex, true);
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

/** Puts it into `host`, which stays scrolled to where it is. */
export function showTaskPage(page: TaskPage, host: HTMLElement): void {
  const { scrollTop } = host;
  host.replaceChildren(...page.blocks.map(blockToDom));
  host.scrollTop = scrollTop;
}
