// What was shown in the last seconds.

import type { Frame, Layout, ViewValue } from "./view_frames.ts";

export const kPast = 240; // frames that are remembered: eight seconds at thirty a second
export const kPayWindow = 0.3; // what was paid is a rate over so long [s]
const kDense = 0.1; // between two frames, if no action is to be missed [s]

export interface Entry {
  frame: Frame;
  startsEpisode: boolean; // the one before is of another episode
  rates: Map<ViewValue, number>; // of each term what it pays [1/s]
  ofAction: Map<ViewValue, number>; // of each term what it has paid for the present action; or none
}

export class History {
  readonly entries: Entry[] = [];
  layout: Layout | undefined;
  private terms: ViewValue[] = [];
  private atAction = new Map<ViewValue, number>(); // sums when the present action began
  private isDense = false;

  get last(): Entry | undefined {
    return this.entries.at(-1);
  }

  /** Returns whether the frame's numbers are other things than those before. */
  add(frame: Frame): boolean {
    const { layout } = frame.clip;
    const isOther = layout !== this.layout;
    if (isOther) {
      this.layout = layout;
      this.terms = layout.values.filter(({ kind }) => kind === "term");
      this.entries.length = 0;
    }
    if (this.last && isBehind(frame, this.last.frame)) this.entries.length = 0;
    const before = this.last?.frame;
    const startsEpisode =
      before?.clip.episode !== frame.clip.episode || before.time > frame.time + 1e-6;
    this.followAction(frame, startsEpisode ? undefined : before);
    this.entries.push({
      frame,
      startsEpisode,
      rates: this.ratesAt(frame, startsEpisode),
      ofAction: this.isDense ? this.paidForAction(frame) : new Map(),
    });
    if (this.entries.length > kPast) this.entries.shift();
    return isOther;
  }

  private ratesAt(frame: Frame, startsEpisode: boolean): Map<ViewValue, number> {
    const past = startsEpisode ? undefined : this.frameBefore(frame.time - kPayWindow);
    const seconds = frame.time - (past?.time ?? 0);
    return new Map(
      this.terms.map((term) => {
        const paid = frame.number(term.first) - (past?.number(term.first) ?? 0);
        return [term, seconds > 0 ? paid / seconds : 0];
      }),
    );
  }

  /** The latest frame of this episode that is not after `time`, or else its first one. */
  private frameBefore(time: number): Frame | undefined {
    for (let i = this.entries.length - 1; i >= 0; --i) {
      const { frame, startsEpisode } = this.entries[i] as Entry;
      if (frame.time <= time + 1e-6 || startsEpisode) return frame;
    }
    return undefined;
  }

  private followAction(frame: Frame, before: Frame | undefined): void {
    this.isDense = frame.time - (before?.time ?? 0) <= kDense;
    if (before && before.actions === frame.actions) return;
    // What was paid since the last frame belongs to the action that was over in between.
    this.atAction = new Map(this.terms.map((term) => [term, before ? frame.number(term.first) : 0]));
  }

  private paidForAction(frame: Frame): Map<ViewValue, number> {
    return new Map(
      this.terms.map((term) => [term, frame.number(term.first) - (this.atAction.get(term) ?? 0)]),
    );
  }
}

/** Somebody has gone back in an episode. */
const isBehind = (frame: Frame, last: Frame): boolean =>
  frame.clip === last.clip && frame.index < last.index;
