// What the server says of the runs in its folder (docs/api.md, "Many runs").

export interface Run {
  name: string;
  state: "waiting" | "starting" | "running" | "paused" | "finished" | "stopped" | "failed";
  failure: string;
  episodes: number;
  episodes_planned: number;
  sparkline: (number | null)[];
  address: string; // of its page while it is trained; or ""
  // Of a run that is made:
  task?: string;
  robot?: string;
  profile?: string;
  seed?: number;
  last_return?: number | null;
  mean_return?: number | null;
  best_return?: number | null;
  speed?: number | null;
  seconds_left?: number | null;
}

export interface RunListing {
  folder: string;
  runs: Run[];
}

/** Whether a trainer works on it, or is about to. */
export const isTrained = ({ state }: Run): boolean =>
  state === "waiting" || state === "starting" || state === "running" || state === "paused";

/** What it was trained for, and how: only runs that have this in common have a mean. */
export const kindOf = ({ task, robot, profile }: Run): string =>
  [task, robot, profile].filter(Boolean).join(" · ");
