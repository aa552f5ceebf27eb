// The modules of the run and how their ports are connected: drawn, and rewired by drawing a line
// from one port to another.

import { formatNumber } from "../data/words.ts";
import { byId, element } from "../page/dom.ts";
import {
  kModuleWidth,
  placeGraph,
  type Connection,
  type Graph,
  type PlacedModule,
  type PlacedPort,
} from "./graph_layout.ts";
import { ask } from "./trainer.ts";

const kSvg = "http://www.w3.org/2000/svg";
const kMargin = 12;

function draw<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string | number>,
  ...children: Node[]
): SVGElementTagNameMap[Tag] {
  const made = document.createElementNS(kSvg, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.append(...children);
  return made;
}

function label(x: number, y: number, words: string, kind: string): SVGTextElement {
  const text = draw("text", { x, y, class: kind });
  text.textContent = words;
  return text;
}

const curve = (x0: number, y0: number, x1: number, y1: number): string => {
  const bend = Math.max(40, Math.abs(x1 - x0) / 2);
  return `M${x0} ${y0}C${x0 + bend} ${y0} ${x1 - bend} ${y1} ${x1} ${y1}`;
};

export class GraphPanel {
  private readonly host = byId("graph", HTMLElement);
  private readonly words = byId("graph-words", HTMLElement);
  private readonly cut = byId("graph-cut", HTMLButtonElement);
  private readonly all = byId("graph-all", HTMLInputElement);
  private graph: Graph | undefined;
  private shown = "";
  private places = new Map<string, PlacedPort>();
  private svg: SVGSVGElement | undefined;
  private chosen: Connection | undefined;
  private drawn: { from: PlacedPort; line: SVGPathElement } | undefined;

  /** `valueOf`: what the out port of this name shows now, if that is known. */
  constructor(
    private readonly valueOf: (port: string) => string | undefined,
    private readonly onChange: () => void,
  ) {
    this.all.addEventListener("change", () => this.draw());
    this.cut.addEventListener("click", () => void this.disconnect());
    document.addEventListener("pointerup", (event) => void this.drop(event));
    document.addEventListener("pointermove", (event) => this.drag(event));
  }

  async refresh(): Promise<void> {
    const { text } = await ask<{ text: string }>("graph?format=json");
    if (text === this.shown) return;
    this.shown = text;
    this.graph = JSON.parse(text) as Graph;
    this.draw();
  }

  private draw(): void {
    if (!this.graph) return;
    const modules = placeGraph(this.graph, this.all.checked);
    this.places = new Map(modules.flatMap(({ ports }) => ports.map((port) => [port.fullName, port])));
    const right = Math.max(...modules.map(({ x }) => x + kModuleWidth));
    const bottom = Math.max(...modules.map(({ y, height }) => y + height));
    const [width, height] = [right + 2 * kMargin, bottom + 2 * kMargin];
    this.svg = draw("svg", {
      viewBox: `${-kMargin} ${-kMargin} ${width} ${height}`,
      width,
      height,
      role: "img",
      "aria-label": "The modules of the run and the connections of their ports",
    });
    // What passes a module passes behind it.
    this.svg.append(...this.graph.connections.map((each) => this.drawConnection(each)));
    this.svg.append(...modules.map((each) => this.drawModule(each)));
    this.host.replaceChildren(this.svg);
    this.choose(undefined);
    byId("graph-list", HTMLElement).replaceChildren(
      ...this.graph.connections.map((each) => this.listed(each)),
    );
  }

  private drawModule({ module, x, y, height, ports }: PlacedModule): SVGGElement {
    const box = draw("rect", { x, y, width: kModuleWidth, height, rx: 7, class: "module" });
    const parameters = Object.entries(module.parameters).map(([name, value]) => `${name} = ${value}`);
    const title = draw("title", {});
    title.textContent = [module.name, ...parameters].join("\n");
    const head = label(x + 10, y + 19, module.name, "module-name");
    return draw("g", {}, title, box, head, ...ports.map((port) => this.drawPort(port, x)));
  }

  private drawPort(place: PlacedPort, left: number): SVGGElement {
    const { port, fullName, x, y } = place;
    const dot = draw("circle", { cx: x, cy: y, r: 4.5, class: `port ${port.kind.replace(" ", "-")}` });
    const text = label(place.isSource ? left + kModuleWidth - 10 : left + 10, y + 4, port.name, "port-name");
    if (place.isSource) text.setAttribute("text-anchor", "end");
    const group = draw("g", { class: "port-group", "data-port": fullName }, dot, text);
    group.addEventListener("pointerenter", () => this.describe(place));
    group.addEventListener("pointerdown", (event) => this.start(event, place));
    return group;
  }

  private drawConnection(connection: Connection): SVGPathElement {
    const [from, to] = [this.places.get(connection.from), this.places.get(connection.to)];
    const isValue = from?.port.kind === "out port";
    const path = draw("path", {
      d: from && to ? curve(from.x, from.y, to.x, to.y) : "",
      class: isValue ? "connection value" : "connection",
      "data-from": connection.from,
      "data-to": connection.to,
    });
    path.addEventListener("click", () => this.choose(connection));
    return path;
  }

  /** For those who do not see the picture, or have no pointer. */
  private listed(connection: Connection): HTMLElement {
    const button = element("button", { type: "button", class: "text" }, "choose");
    button.addEventListener("click", () => this.choose(connection));
    return element("li", {}, `${connection.from} → ${connection.to} `, button);
  }

  private describe({ port, fullName }: PlacedPort): void {
    if (this.drawn) return;
    const value = this.valueOf(port.name);
    const words = [fullName, `${port.kind}, ${port.type}`, value && `now ${value}`];
    this.words.textContent = words.filter(Boolean).join("  ·  ");
  }

  private choose(connection: Connection | undefined): void {
    this.chosen = connection;
    this.cut.hidden = connection === undefined;
    for (const path of this.svg?.querySelectorAll<SVGPathElement>(".connection") ?? []) {
      const { from, to } = path.dataset;
      path.toggleAttribute("data-chosen", from === connection?.from && to === connection?.to);
    }
    if (connection) this.words.textContent = `${connection.from} → ${connection.to}, ${connection.type}`;
  }

  private start(event: PointerEvent, from: PlacedPort): void {
    event.preventDefault();
    const line = draw("path", { class: "connection drawn" });
    this.svg?.append(line);
    this.drawn = { from, line };
  }

  private drag(event: PointerEvent): void {
    if (!this.drawn || !this.svg) return;
    const matrix = this.svg.getScreenCTM()?.inverse();
    if (!matrix) return;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    const { from, line } = this.drawn;
    line.setAttribute("d", from.isSource ? curve(from.x, from.y, x, y) : curve(x, y, from.x, from.y));
  }

  private async drop(event: PointerEvent): Promise<void> {
    if (!this.drawn) return;
    const { from, line } = this.drawn;
    this.drawn = undefined;
    line.remove();
    const target = document.elementFromPoint(event.clientX, event.clientY);
    const second = target?.closest<SVGGElement>("[data-port]")?.dataset["port"];
    if (second === undefined || second === from.fullName) return;
    await this.change("connect", from.fullName, second);
  }

  private disconnect(): Promise<void> {
    const { chosen } = this;
    return chosen ? this.change("disconnect", chosen.from, chosen.to) : Promise.resolve();
  }

  /** What the trainer refuses is explained where the picture is. */
  private async change(command: string, first: string, second: string): Promise<void> {
    const refusal = byId("graph-refusal", HTMLElement);
    refusal.textContent = "";
    try {
      await ask(command, { first, second });
      this.words.textContent = `${command}: ${first}, ${second}`;
      await this.refresh();
      this.onChange();
    } catch (error) {
      refusal.textContent = (error as Error).message;
    }
  }
}

/** Up to a few numbers as text. */
export const numbersInWords = (numbers: ArrayLike<number>): string =>
  Array.from(numbers).slice(0, 4).map(formatNumber).join("  ") + (numbers.length > 4 ? " …" : "");
