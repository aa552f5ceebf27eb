// A button that plays, a slider over the time of an episode, and a clock.

import { formatTime } from "../data/words.ts";
import { byId } from "../page/dom.ts";

/** Where a replay is. */
export interface Moment {
  time: number; // [s]
  duration: number; // [s]
  isPlaying: boolean;
}

export class Scrubber {
  readonly slider: HTMLInputElement;
  private readonly playButton: HTMLButtonElement;
  private readonly clock: HTMLElement;
  private duration = 0;
  private interval = 0;

  /** `name`: what the ids of its parts begin with; `words`: what its button does. */
  constructor(
    name: string,
    onToggle: () => void,
    onSeek: (time: number) => void,
    private readonly words = { play: "Play", pause: "Pause" },
  ) {
    this.slider = byId(`${name}scrub`, HTMLInputElement);
    this.playButton = byId(`${name}play`, HTMLButtonElement);
    this.clock = byId(`${name}clock`, HTMLElement);
    this.playButton.addEventListener("click", onToggle);
    this.slider.addEventListener("input", () => onSeek(this.timeOf(this.slider.valueAsNumber)));
  }

  /** Between two of its steps [s]. */
  setInterval(interval: number): void {
    this.interval = interval;
    this.slider.step = String(interval);
  }

  show({ time, duration, isPlaying }: Moment): void {
    this.duration = duration;
    this.setEnabled(true);
    this.playButton.setAttribute("aria-label", isPlaying ? this.words.pause : this.words.play);
    this.playButton.dataset["state"] = isPlaying ? "playing" : "paused";
    this.slider.max = String(duration);
    this.slider.value = String(time);
    this.slider.setAttribute(
      "aria-valuetext",
      `${time.toFixed(2)} of ${duration.toFixed(2)} seconds`,
    );
    this.slider.style.setProperty("--done", `${duration > 0 ? (100 * time) / duration : 0}%`);
    this.clock.textContent = `${formatTime(time, duration)} / ${duration.toFixed(2)} s`;
  }

  /** Where there is nothing to go through. */
  setEnabled(isEnabled: boolean): void {
    if (this.slider.disabled !== isEnabled) return;
    this.slider.disabled = !isEnabled;
    this.playButton.disabled = !isEnabled;
    if (!isEnabled) this.clock.textContent = "";
  }

  /** The last step of the slider leads to the end of the episode, which may be less than a step. */
  private timeOf(time: number): number {
    return time + this.interval > this.duration + 1e-6 ? this.duration : time;
  }
}
