// Snapshots of the replay side by side, as a paper prints a motion. A click leads there.

import { formatTime } from "../data/words.ts";
import { element, leaveAfterClick } from "../page/dom.ts";
import { durationOf, snapshotTimes, type Motion } from "./motion.ts";
import type { Player } from "./player.ts";
import type { Stage } from "./stage.ts";

const kSnapshots = 8;
const kPixels = 360; // of each picture

export class Strip {
  private readonly canvases: HTMLCanvasElement[] = [];
  private readonly captions: HTMLElement[] = [];
  private readonly buttons: HTMLButtonElement[] = [];
  private times: number[] = [];
  private recording: Motion | undefined;

  constructor(
    host: HTMLElement,
    private readonly span: HTMLSelectElement,
    private readonly stage: Stage,
    private readonly player: Player,
  ) {
    for (let i = 0; i < kSnapshots; ++i) host.append(this.makeSnapshot(i));
    span.addEventListener("change", () => this.take());
    player.onChange(() => this.showPlace());
  }

  show(recording: Motion): void {
    this.recording = recording;
    this.span.value = "";
    this.take();
  }

  /** Takes the snapshots again: of the whole episode, or of what follows the present moment. */
  take(): void {
    if (!this.recording) return;
    const seconds = Number(this.span.value);
    const whole = this.span.value === "";
    const start = whole ? 0 : this.player.time;
    const duration = durationOf(this.recording);
    this.times = snapshotTimes(duration, start, whole ? duration : seconds, kSnapshots);
    this.redraw();
    this.times.forEach((time, i) => {
      const words = `${formatTime(time, duration).trim()} s`;
      (this.captions[i] as HTMLElement).textContent = words;
      this.buttons[i]?.setAttribute("aria-label", `Snapshot: go to ${words}`);
    });
    this.showPlace();
  }

  /** The same moments in another light or from another side. */
  redraw(): void {
    if (this.recording) this.stage.drawSnapshots(this.times, this.canvases);
  }

  private makeSnapshot(index: number): HTMLElement {
    const canvas = element("canvas", { width: `${kPixels}`, height: `${kPixels}` });
    const caption = element("span", { class: "caption" });
    const button = element("button", { type: "button" }, canvas, caption);
    button.addEventListener("click", (event) => {
      leaveAfterClick(button, event);
      this.player.pause();
      this.player.seek(this.times[index] ?? 0);
    });
    this.canvases.push(canvas);
    this.captions.push(caption);
    this.buttons.push(button);
    return element("li", {}, button);
  }

  /** Marks the last snapshot that the replay has reached. */
  private showPlace(): void {
    const reached = this.times.findLastIndex((time) => time <= this.player.time + 1e-6);
    this.buttons.forEach((button, i) => {
      if (i === reached) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    });
  }
}
