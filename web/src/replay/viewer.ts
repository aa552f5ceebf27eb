// The replay with its controls: buttons, slider, keys, and the loop that draws while it plays.

import type { Scenery } from "../data/report_data.ts";
import { formatLength, formatTime } from "../data/words.ts";
import { byId, onThemeChange } from "../page/dom.ts";
import { durationOf, type Replay } from "./motion.ts";
import { Player } from "./player.ts";
import { Stage } from "./stage.ts";
import { Strip } from "./strip.ts";
import { toldAt } from "./told.ts";

const kSettleTime = 250; // after the last move of the camera, before the strip follows [ms]

export class Viewer {
  private readonly player = new Player();
  private readonly stage: Stage;
  private readonly strip: Strip;
  private readonly frame = byId("stage", HTMLElement);
  private readonly playButton = byId("play", HTMLButtonElement);
  private readonly slider = byId("scrub", HTMLInputElement);
  private readonly clock = byId("clock", HTMLElement);
  private readonly place = byId("place", HTMLElement);
  private readonly told = byId("told", HTMLElement);
  private recording: Replay | undefined;
  private lastFrame: number | undefined;
  private isDrawPlanned = false;
  private settleTimer = 0;

  constructor(scenery: Scenery) {
    this.stage = new Stage(scenery, () => this.onView());
    this.stage.canvas.tabIndex = 0;
    this.stage.canvas.setAttribute("role", "img");
    this.frame.prepend(this.stage.canvas);
    this.strip = new Strip(
      byId("strip", HTMLElement),
      byId("span", HTMLSelectElement),
      this.stage,
      this.player,
    );
    this.connectControls();
    this.connectView();
    document.addEventListener("keydown", (event) => this.onKey(event));
    this.player.onChange(() => this.update());
  }

  /** `opening`: the time that is shown first [s]. */
  show(recording: Replay, opening = 0): void {
    this.recording = recording;
    const duration = durationOf(recording);
    this.slider.max = String(duration);
    this.slider.step = String(recording.interval);
    this.stage.canvas.setAttribute(
      "aria-label",
      `The robot in episode ${recording.episode}, ${duration.toFixed(1)} seconds`,
    );
    for (const id of ["contacts-label", "touching"]) {
      byId(id, HTMLElement).hidden = recording.timeline === undefined;
    }
    this.stage.show(recording);
    this.player.load(duration, opening);
    this.strip.show(recording);
  }

  /** For recordings of another robot. */
  setScenery(scenery: Scenery): void {
    this.stage.setScenery(scenery);
  }

  pause(): void {
    this.player.pause();
  }

  seek(time: number): void {
    this.player.seek(time);
  }

  /** Called with the time that is shown whenever that changes. */
  onTime(listener: (time: number) => void): void {
    this.player.onChange(() => listener(this.player.time));
  }

  /** Called with the time at which the replay stands when somebody has led it there. */
  onRest(listener: (time: number) => void): void {
    this.player.onChange(() => {
      if (!this.player.playing && !this.player.untouched) listener(this.player.time);
    });
  }

  play(): void {
    this.player.play();
  }

  private connectControls(): void {
    const { player, stage } = this;
    const follow = byId("follow", HTMLInputElement);
    const speed = byId("speed", HTMLSelectElement);
    this.playButton.addEventListener("click", () => player.toggle());
    this.slider.addEventListener("input", () => this.slide(this.slider.valueAsNumber));
    speed.addEventListener("change", () => player.setSpeed(Number(speed.value)));
    follow.addEventListener("change", () => {
      stage.setFollowing(follow.checked);
      this.planDraw();
    });
    const contacts = byId("contacts-lit", HTMLInputElement);
    contacts.addEventListener("change", () => {
      stage.setLightingContacts(contacts.checked);
      this.planDraw();
    });
    byId("reset-view", HTMLButtonElement).addEventListener("click", () => stage.resetView());
  }

  /** The last step of the slider leads to the end of the episode, which may be less than a step. */
  private slide(time: number): void {
    const { duration } = this.player;
    const step = this.recording?.interval ?? 0;
    this.player.seek(time + step > duration + 1e-6 ? duration : time);
  }

  private connectView(): void {
    const { canvas } = this.stage;
    canvas.addEventListener("focus", () => this.stage.setZoomable(true));
    canvas.addEventListener("blur", () => this.stage.setZoomable(false));
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener("dblclick", () => this.stage.resetView());
    this.stage.setZoomable(false);
    new ResizeObserver(() => {
      this.stage.setSize(this.frame.clientWidth, this.frame.clientHeight);
      this.stage.draw();
    }).observe(this.frame);
    onThemeChange(() => {
      this.stage.updateTheme();
      this.strip.redraw();
      this.planDraw();
    });
  }

  /** Space, arrows, Home and End, wherever no other control wants them. */
  private onKey(event: KeyboardEvent): void {
    if (!this.recording || event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as Element;
    const isSlider = target === this.slider;
    if (target.closest("button, select, summary, a, textarea, .chart")) return;
    if (target instanceof HTMLInputElement && !(isSlider && event.key === " ")) return;
    if (!this.command(event.key, event.shiftKey ? 10 : 1)) return;
    event.preventDefault();
  }

  private command(key: string, frames: number): boolean {
    const { player } = this;
    const step = frames * (this.recording?.interval ?? 0);
    const commands: Record<string, () => void> = {
      " ": () => player.toggle(),
      ArrowLeft: () => player.seek(player.time - step),
      ArrowRight: () => player.seek(player.time + step),
      Home: () => player.seek(0),
      End: () => player.seek(player.duration),
    };
    commands[key]?.();
    return key in commands;
  }

  /** Shows the player's state in the controls and in the picture. */
  private update(): void {
    const { time, duration, playing } = this.player;
    this.playButton.setAttribute("aria-label", playing ? "Pause" : "Play");
    this.playButton.dataset["state"] = playing ? "playing" : "paused";
    this.slider.value = String(time);
    this.slider.setAttribute(
      "aria-valuetext",
      `${time.toFixed(2)} of ${duration.toFixed(2)} seconds`,
    );
    this.slider.style.setProperty("--done", `${duration > 0 ? (100 * time) / duration : 0}%`);
    this.clock.textContent = `${formatTime(time, duration)} / ${duration.toFixed(2)} s`;
    if (!playing) this.lastFrame = undefined;
    this.planDraw();
  }

  private planDraw(): void {
    if (this.isDrawPlanned) return;
    this.isDrawPlanned = true;
    requestAnimationFrame((now) => this.drawFrame(now));
  }

  private drawFrame(now: number): void {
    this.isDrawPlanned = false;
    if (this.player.playing) {
      // A page that was in the background goes on from where it was.
      const passed = Math.min(now - (this.lastFrame ?? now), 250) / 1000;
      this.lastFrame = now;
      this.player.advance(passed);
      if (this.player.playing) this.planDraw();
    }
    this.stage.setTime(this.player.time);
    this.stage.draw();
    const [x, y, z] = this.stage.place.map(formatLength);
    this.place.textContent = `x ${x}  y ${y}  z ${z} m`;
    this.told.textContent = toldAt(this.recording?.goals ?? [], this.player.time);
  }

  private onView(): void {
    this.planDraw();
    window.clearTimeout(this.settleTimer);
    this.settleTimer = window.setTimeout(() => {
      if (!this.player.playing) this.strip.redraw();
    }, kSettleTime);
  }
}
