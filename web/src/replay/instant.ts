// What is known of a robot at one time besides where its links are.

import type { ToldGoal } from "../data/report_data.ts";
import { sampleAt, touches } from "../data/timeline.ts";
import type { Motion } from "./motion.ts";
import { goalsAt } from "./told.ts";

export interface Instant {
  touches: (link: number) => boolean;
  forces: Float32Array | undefined; // of all contacts of each link, [link][x, y, z] [N]
  goals: ToldGoal[]; // as they hold now
}

export const kNothingKnown: Instant = { touches: () => false, forces: undefined, goals: [] };

/** What a motion of `bodies` says of `time` [s]; what it does not say is as it was. */
export function instantOf(motion: Motion, bodies: number, time: number, was: Instant): Instant {
  const { timeline, goals } = motion;
  const sample = timeline ? sampleAt(timeline, time) : 0;
  return {
    ...was,
    ...(goals && { goals: goalsAt(goals, time) }),
    ...(timeline && { touches: (link: number) => touches(timeline, bodies, sample, link) }),
  };
}
