// The replay with its controls: buttons, slider, keys, and the loop that draws while it plays.

import type { Scenery } from "../data/report_data.ts";
import { byId, onThemeChange } from "../page/dom.ts";
import { AidSwitches } from "./aid_switches.ts";
import { Companion, type Other } from "./companion.ts";
import { FilmRecorder } from "./film_recorder.ts";
import { durationOf, type Replay } from "./motion.ts";
import { mountStage } from "./mount_stage.ts";
import { Player } from "./player.ts";
import { Scrubber } from "./scrubber.ts";
import type { Stage } from "./stage.ts";
import { StageWords } from "./stage_words.ts";
import { Strip } from "./strip.ts";

const kSettleTime = 250; // after the last move of the camera, before the strip follows [ms]

export class Viewer {
  private readonly player = new Player();
  private readonly stage: Stage;
  private readonly strip: Strip;
  private readonly scrubber = new Scrubber(
    "",
    () => this.player.toggle(),
    (time) => this.player.seek(time),
  );
  private readonly title = byId("stage-title", HTMLElement);
  private readonly words = new StageWords();
  private readonly aids = new AidSwitches(() => this.planDraw());
  private readonly companion = new Companion(this.aids, (stage) => this.onOtherView(stage));
  private readonly film = new FilmRecorder(
    this.player,
    () => [this.stage.canvas, ...this.companion.canvases],
    () => this.title.textContent ?? "replay",
  );
  private recording: Replay | undefined;
  private lastFrame: number | undefined;
  private isDrawPlanned = false;
  private settleTimer = 0;

  constructor(private scenery: Scenery) {
    this.stage = mountStage(
      scenery,
      byId("stage", HTMLElement),
      () => this.onView(),
      () => this.planDraw(),
    );
    this.aids.connect(this.stage);
    this.strip = new Strip(
      byId("strip", HTMLElement),
      byId("span", HTMLSelectElement),
      this.stage,
      this.player,
    );
    this.connectControls();
    this.connectTheme();
    document.addEventListener("keydown", (event) => this.onKey(event));
    this.player.onChange(() => this.update());
  }

  /** `opening`: the time that is shown first [s]; `title`: what it is, where another is beside it. */
  show(recording: Replay, opening = 0, title = `episode ${recording.episode}`): void {
    this.recording = recording;
    const duration = durationOf(recording);
    this.scrubber.setInterval(recording.interval);
    this.stage.canvas.setAttribute(
      "aria-label",
      `The robot in episode ${recording.episode}, ${duration.toFixed(1)} seconds`,
    );
    this.title.textContent = title;
    this.offerAids();
    this.stage.show(recording);
    this.player.load(this.duration, opening);
    this.strip.show(recording);
  }

  /** Shows another replay beside this one, in step with it; or nothing more. */
  showBeside(other: Other | undefined): void {
    this.title.hidden = other === undefined;
    this.companion.show(other);
    this.companion.lookFrom(this.stage);
    this.offerAids();
    this.player.setDuration(this.duration);
    this.planDraw();
  }

  /** Of the longer one [s]. */
  private get duration(): number {
    return Math.max(this.recording ? durationOf(this.recording) : 0, this.companion.duration);
  }

  private offerAids(): void {
    const { recording, scenery } = this;
    const hasContacts = recording?.timeline !== undefined;
    this.aids.offer({ body: scenery.body, hasContacts, goals: recording?.goals ?? [] });
  }

  /** Called with the link whose joints are to be shown. */
  onPick(listener: (link: number | undefined) => void): void {
    this.aids.onPick(listener);
  }

  /** For recordings of another robot. */
  setScenery(scenery: Scenery): void {
    this.scenery = scenery;
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
    speed.addEventListener("change", () => player.setSpeed(Number(speed.value)));
    follow.addEventListener("change", () => {
      stage.setFollowing(follow.checked);
      this.companion.setFollowing(follow.checked);
      this.planDraw();
    });
    byId("reset-view", HTMLButtonElement).addEventListener("click", () => stage.resetView());
  }

  private connectTheme(): void {
    onThemeChange(() => {
      this.stage.updateTheme();
      this.companion.updateTheme();
      this.strip.redraw();
      this.planDraw();
    });
  }

  /** Space, arrows, Home and End, wherever no other control wants them. */
  private onKey(event: KeyboardEvent): void {
    if (!this.recording || event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as Element;
    const isSlider = target === this.scrubber.slider;
    if (target.closest("button, select, summary, a, textarea, pre, .scroll, .chart")) return;
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
    this.scrubber.show({ time, duration, isPlaying: playing });
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
    this.companion.setTime(this.player.time);
    if (this.stage.isInSight || this.film.isRecording) this.drawStages();
    if (!this.recording) return;
    const { stage, recording, scenery, player } = this;
    this.words.show(stage, recording, scenery.body, player.time, this.aids.picked);
  }

  private drawStages(): void {
    this.stage.draw();
    this.companion.draw();
    this.film.take();
  }

  /** Both cameras are moved by whichever the user moves. */
  private onOtherView(stage: Stage): void {
    this.stage.view = stage.view;
    this.onView();
  }

  private onView(): void {
    this.companion.lookFrom(this.stage);
    this.planDraw();
    window.clearTimeout(this.settleTimer);
    this.settleTimer = window.setTimeout(() => {
      if (!this.player.playing) this.strip.redraw();
    }, kSettleTime);
  }
}
