// Which frame is shown now: the latest instant of the training, or a whole episode at a pace that
// eyes can follow, one after the other.

import { decodeClip, decodeLayout, Frame, type Clip, type Layout } from "./view_frames.ts";
import type { Moment } from "../replay/scrubber.ts";
import { kPast } from "./history.ts";
import { LastingSocket } from "./trainer.ts";

/** "instants", or how many times real time. */
export type Pace = "instants" | number;

const kAhead = 3; // the next episode is asked for so long before this one is over [s]

export interface Shown {
  frame: Frame;
  time: number; // of the picture, which may lie between two frames [s]
  passed: Frame[]; // since the last call, this one the last; none: it is the same
}

export class ViewSource {
  private readonly socket: LastingSocket;
  private layout: Layout | undefined;
  private pace: Pace = 1;
  private isPaused = false;
  private isHidden = false;
  private stands = false; // the episode, where somebody looks at it
  private clip: Clip | undefined;
  private next: Clip | undefined;
  private isAsked = false;
  private time = 0;
  private mustChange = false; // to the next episode, as soon as it is there
  private shown: Frame | undefined;

  constructor() {
    this.socket = new LastingSocket("/api/view", {
      onOpen: () => this.askAgain(),
      onMessage: (data) => this.take(data),
    });
  }

  setPace(pace: Pace): void {
    this.pace = pace;
    this.askAgain();
  }

  /** Lets the episode that is shown stand still, or go on. */
  toggle(): void {
    this.stands = !this.stands;
  }

  /** Stands still at a time of the episode that is shown. */
  seek(time: number): void {
    this.stands = true;
    this.time = Math.min(Math.max(time, 0), this.duration);
  }

  /** Of the whole episode that is shown. */
  get moment(): (Moment & { interval: number }) | undefined {
    const { clip, duration, isPlaying } = this;
    if (this.showsInstants || !clip?.isEpisode) return undefined;
    return { time: Math.min(this.time, duration), duration, isPlaying, interval: clip.interval };
  }

  /** While the run is paused, the instant is shown at which it is, whatever the pace. */
  setPaused(isPaused: boolean): void {
    if (this.isPaused === isPaused) return;
    this.isPaused = isPaused;
    this.askAgain();
  }

  /** Another task is there: what was asked for, and the rest of what is shown, are of no more use. */
  startOver(): void {
    if (this.showsInstants) return;
    this.mustChange = true;
    this.askAgain();
  }

  /** Nothing is sent for a page that nobody sees. */
  setHidden(isHidden: boolean): void {
    this.isHidden = isHidden;
    this.askAgain();
  }

  get showsInstants(): boolean {
    return this.pace === "instants" || this.isPaused;
  }
  get rate(): number {
    return this.pace === "instants" ? 1 : this.pace;
  }
  get isHeld(): boolean {
    return this.stands;
  }
  get isPlaying(): boolean {
    return !this.showsInstants && !this.stands && this.clip !== undefined;
  }

  /** `seconds` of the viewer's time have passed; what is to be seen now. */
  advance(seconds: number): Shown | undefined {
    if (this.isPlaying) this.time += seconds * this.rate;
    if (!this.showsInstants && !this.stands) this.changeEpisode();
    const { clip } = this;
    if (!clip) return undefined;
    const index = clip.isEpisode ? Math.floor(this.time / clip.interval + 1e-6) : 0;
    const frame = new Frame(clip, Math.min(index, clip.frames - 1));
    const passed: Frame[] = [];
    for (let i = this.firstBefore(frame); i <= frame.index; ++i) passed.push(new Frame(clip, i));
    this.shown = frame;
    return { frame, time: clip.isEpisode ? this.time : 0, passed };
  }

  /** Of what has passed up to `frame`: what was not shown yet, or what was before it all. */
  private firstBefore({ clip, index }: Frame): number {
    const { shown } = this;
    if (shown?.clip !== clip) return 0;
    return index >= shown.index ? shown.index + 1 : Math.max(0, index + 1 - kPast);
  }

  /** Of the episode that is shown [s]. */
  private get duration(): number {
    return this.clip?.isEpisode ? (this.clip.frames - 1) * this.clip.interval : 0;
  }

  private get left(): number {
    return this.clip?.isEpisode ? (this.duration - this.time) / this.rate : 0;
  }

  private changeEpisode(): void {
    if ((this.left <= 0 || this.mustChange) && this.next) {
      [this.clip, this.next, this.time, this.mustChange] = [this.next, undefined, 0, false];
    }
    if (this.left < kAhead && !this.next && !this.isAsked) {
      this.isAsked = true;
      this.socket.send("episode");
    }
  }

  private askAgain(): void {
    this.next = undefined;
    if (this.showsInstants) this.stands = false;
    this.isAsked = !this.showsInstants;
    const wish = this.showsInstants ? "instants" : "episode";
    this.socket.send(this.isHidden ? "nothing" : wish);
  }

  private take(data: string | ArrayBuffer): void {
    if (typeof data === "string") {
      this.layout = decodeLayout(data);
      return;
    }
    if (!this.layout) return;
    const clip = decodeClip(this.layout, data);
    if (clip.isEpisode === this.showsInstants) return; // asked for before the pace was changed
    if (clip.isEpisode) {
      this.isAsked = false;
      this.next = clip;
      if (!this.clip?.isEpisode) this.changeEpisode();
    } else {
      this.clip = clip;
    }
  }
}
