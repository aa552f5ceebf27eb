// All runs, a row for each.

import { formatCount, formatEstimate, formatNumber, formatRatio } from "../data/words.ts";
import { addressOf } from "../live/trainer.ts";
import { drawSparkline } from "../page/canvas.ts";
import { element, readout } from "../page/dom.ts";
import { isTrained, kindOf, type Run } from "./run.ts";

const kHeads = ["", "run", "state", "episodes", "mean return", "", "best", "speed", "left", ""];

export interface RowListeners {
  onChoose: () => void;
  onCommand: (command: "pause" | "resume" | "stop", run: string) => void;
}

class RunRow {
  readonly element: HTMLTableRowElement;
  readonly chosen: HTMLInputElement;
  private readonly swatch = element("span", { class: "swatch", "aria-hidden": "true" });
  private readonly words = element("span", { class: "note" });
  private readonly state = element("span", { class: "state" });
  private readonly failure = element("pre", { class: "refusal" });
  private readonly episodes = element("span");
  private readonly bar = element("progress", { max: "1", value: "0" });
  private readonly mean = readout();
  private readonly spark = element("canvas", { class: "run-spark", "aria-hidden": "true" });
  private readonly best = readout();
  private readonly speed = readout();
  private readonly left = readout();
  private readonly open = element("a", { class: "button" }, "Open");
  private readonly pause = element("button", { type: "button", class: "button" });
  private readonly stop = element("button", { type: "button", class: "button" }, "Stop");
  private run: Run | undefined;

  constructor(
    readonly name: string,
    listeners: RowListeners,
  ) {
    this.chosen = element("input", { type: "checkbox", "aria-label": `compare ${name}` });
    this.chosen.addEventListener("change", listeners.onChoose);
    this.bar.setAttribute("aria-label", `episodes of ${name} that are done`);
    this.pause.addEventListener("click", () =>
      listeners.onCommand(this.run?.state === "running" ? "pause" : "resume", name),
    );
    this.stop.addEventListener("click", () => listeners.onCommand("stop", name));
    const cells: [string, ...(Node | string)[]][] = [
      ["choice", element("label", {}, this.chosen, this.swatch)],
      ["name", element("strong", {}, name), this.words],
      ["state-cell", this.state],
      ["episodes", this.episodes, this.bar],
      ["mean", this.mean],
      ["spark-cell", this.spark],
      ["best", this.best],
      ["speed", this.speed],
      ["left", this.left],
      ["actions", element("div", { class: "live-actions" }, this.open, this.pause, this.stop)],
    ];
    this.element = element("tr", { "data-run": name });
    for (const [kind, ...content] of cells) {
      this.element.append(element("td", { class: kind }, ...content));
    }
  }

  show(run: Run): void {
    this.run = run;
    const { state, episodes, episodes_planned: planned } = run;
    this.words.textContent = [kindOf(run), run.seed === undefined ? "" : `seed ${run.seed}`]
      .filter(Boolean)
      .join(", ");
    this.state.textContent = state;
    this.state.dataset["state"] = state;
    this.failure.textContent = run.failure;
    if (run.failure && !this.failure.isConnected) this.words.after(this.failure);
    if (!run.failure) this.failure.remove();
    this.episodes.textContent = `${formatCount(episodes)} of ${formatCount(planned)}`;
    this.bar.value = planned > 0 ? episodes / planned : 0;
    this.mean.textContent = formatNumber(run.mean_return ?? NaN);
    this.best.textContent = formatNumber(run.best_return ?? NaN);
    this.speed.textContent = run.speed ? `${formatRatio(run.speed)} ×` : "–";
    this.left.textContent = formatEstimate(run.seconds_left ?? NaN);
    this.showActions(run);
    this.drawSpark();
  }

  color(name: string | undefined): void {
    this.swatch.style.background = name === undefined ? "transparent" : `var(${name})`;
  }

  drawSpark(): void {
    drawSparkline(this.spark, this.run?.sparkline ?? []);
  }

  /** While it is trained its own page is there, and then its report. */
  private showActions(run: Run): void {
    const report = `${addressOf("/report")}&run=${encodeURIComponent(run.name)}`;
    const address = run.address || (run.episodes > 0 ? report : "");
    this.open.hidden = address === "";
    this.open.href = address;
    this.open.textContent = run.address ? "Open" : "Report";
    this.pause.hidden = !["running", "paused", "stopped"].includes(run.state);
    this.pause.textContent = run.state === "running" ? "Pause" : "Resume";
    this.stop.hidden = !isTrained(run) || run.state === "starting";
  }
}

export class RunRows {
  private readonly rows = new Map<string, RunRow>();
  private readonly body = element("tbody");

  constructor(
    host: HTMLElement,
    private readonly listeners: RowListeners,
  ) {
    const heads = kHeads.map((words) =>
      words ? element("th", { scope: "col" }, words) : element("td"),
    );
    const head = element("thead", {}, element("tr", {}, ...heads));
    host.append(element("table", { class: "runs" }, head, this.body));
  }

  show(runs: Run[]): void {
    const names = new Set(runs.map(({ name }) => name));
    for (const [name, row] of this.rows) {
      if (names.has(name)) continue;
      row.element.remove();
      this.rows.delete(name);
    }
    runs.forEach((run, i) => {
      let row = this.rows.get(run.name);
      if (!row) {
        row = new RunRow(run.name, this.listeners);
        this.rows.set(run.name, row);
      }
      if (this.body.children[i] !== row.element) {
        this.body.insertBefore(row.element, this.body.children[i] ?? null);
      }
      row.show(run);
    });
  }

  get chosen(): string[] {
    return [...this.rows.values()].filter(({ chosen }) => chosen.checked).map(({ name }) => name);
  }
  choose(names: string[]): void {
    for (const row of this.rows.values()) row.chosen.checked = names.includes(row.name);
  }
  color(colors: Map<string, string>): void {
    for (const row of this.rows.values()) row.color(colors.get(row.name));
  }
  redraw(): void {
    for (const row of this.rows.values()) row.drawSpark();
  }
}
