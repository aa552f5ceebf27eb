// What the run is doing, and its buttons.

import { formatCount, formatEstimate, formatNumber, formatRatio } from "../data/words.ts";
import { drawSparkline } from "../page/canvas.ts";
import { byId, element, onThemeChange } from "../page/dom.ts";
import type { GrowingRecord } from "./growing_record.ts";
import { ask } from "./trainer.ts";

/** The reply to `status`. */
export interface Status {
  run: string;
  task: string;
  robot: string;
  state: "running" | "paused" | "finished";
  episode: number;
  step: number;
  time: number;
  episodes_done: number;
  episodes_planned: number;
  speed: number;
  last_return: number;
  mean_return: number;
  best_return: number | null;
}

const kStateWords = { running: "running", paused: "paused", finished: "all episodes are done" };
const kSpark = 120; // episodes
const kBetweenLooks = 1000; // [ms]

interface Figure {
  value: HTMLElement;
  note: HTMLElement;
}

export class RunPanel {
  private readonly state = byId("state", HTMLElement);
  private readonly pause = byId("pause", HTMLButtonElement);
  private readonly step = byId("step", HTMLButtonElement);
  private readonly stop = byId("stop", HTMLButtonElement);
  private readonly figures: Record<"episode" | "return" | "best" | "speed" | "left", Figure>;
  private readonly spark = element("canvas", { class: "spark", "aria-hidden": "true" });
  private stops = "";
  status: Status | undefined;

  constructor(
    private readonly record: GrowingRecord,
    private readonly attempt: (action: () => Promise<unknown>) => Promise<void>,
    private readonly onStatus: (status: Status) => void,
  ) {
    const host = byId("figures", HTMLElement);
    const figure = (name: string): Figure => {
      const value = element("dd", { class: "number" }, "–");
      const note = element("dd", { class: "note" });
      host.append(element("div", { class: "figure" }, element("dt", {}, name), value, note));
      return { value, note };
    };
    this.figures = {
      episode: figure("Episode"),
      return: figure("Return"),
      best: figure("Best"),
      speed: figure("Speed"),
      left: figure("Left"),
    };
    this.figures.return.note.after(element("dd", {}, this.spark));
    onThemeChange(() => this.drawSpark());
    this.pause.addEventListener("click", () => this.togglePause());
    this.step.addEventListener("click", () => void this.change("step", { count: 1 }));
    this.stop.addEventListener("click", () => void this.askToStop());
  }

  show(status: Status): void {
    this.status = status;
    const { state, figures, record } = this;
    const { episodes_done: done, episodes_planned: planned } = status;
    state.textContent = this.stops || kStateWords[status.state];
    state.dataset["state"] = status.state;
    byId("run-words", HTMLElement).textContent = `${status.robot}, ${status.run}`;
    byId("task-name", HTMLElement).textContent = status.task.replaceAll("_", " ");
    this.pause.textContent = status.state === "running" ? "Pause" : "Resume";
    this.pause.disabled = status.state === "finished";
    this.step.hidden = status.state !== "paused";
    this.stop.disabled = this.stops !== "";
    this.put(figures.episode, formatCount(status.episode), `of ${formatCount(planned)}`);
    const mean = `mean ${formatNumber(status.mean_return)}`;
    this.put(figures.return, done > 0 ? formatNumber(status.last_return) : "–", done > 0 ? mean : "");
    this.put(figures.best, formatNumber(status.best_return ?? NaN), this.bestNote(status));
    this.put(figures.speed, status.speed > 0 ? `${formatRatio(status.speed)} ×` : "–", "real time");
    const left = planned > done ? formatEstimate(record.secondsFor(planned - done)) : "–";
    this.put(figures.left, left, `${formatCount(planned - done)} episodes`);
    this.onStatus(status);
  }

  showLost(): void {
    this.state.textContent = "the trainer does not answer";
    this.state.dataset["state"] = "lost";
  }

  async refresh(): Promise<void> {
    try {
      this.show(await ask<Status>("status"));
    } catch {
      this.showLost();
    }
  }

  /** Asks again only when there is an answer: of a trainer that takes its time nothing piles up. */
  async follow(): Promise<void> {
    for (;;) {
      await new Promise((done) => window.setTimeout(done, kBetweenLooks));
      if (!document.hidden) await this.refresh();
    }
  }

  drawSpark(): void {
    drawSparkline(this.spark, this.record.returns.slice(-kSpark));
  }

  private bestNote({ best_return: best }: Status): string {
    const { episode } = this.record.best;
    return best === null || episode === 0 ? "" : `in episode ${formatCount(episode)}`;
  }

  private put({ value, note }: Figure, words: string, noteWords: string): void {
    value.textContent = words;
    note.textContent = noteWords;
  }

  private togglePause(): void {
    void this.change(this.status?.state === "running" ? "pause" : "resume", {});
  }

  private change(command: string, args: Record<string, unknown>): Promise<void> {
    return this.attempt(async () => this.show(await ask<Status>(command, args)));
  }

  private askToStop(): Promise<void> {
    return this.attempt(async () => {
      const { stops } = await ask<{ stops: string }>("stop", {});
      this.stops = `stops ${stops}, saved`;
      if (this.status) this.show(this.status);
    });
  }
}
