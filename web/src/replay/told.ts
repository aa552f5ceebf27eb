// What the robot was told at a time of an episode.

import type { ToldGoal } from "../data/report_data.ts";
import { formatTick } from "../data/words.ts";

const textOf = ({ type, value }: ToldGoal): string =>
  value.map((each) => (type === "bool" ? String(each === 1) : formatTick(each))).join(", ");

/** "command 0.3, -0.1 m/s", a line for each goal, in the order in which they were told first. */
export function toldAt(goals: ToldGoal[], time: number): string {
  const lines = new Map<string, string>();
  for (const goal of goals) {
    if (goal.time > time + 1e-6) break;
    lines.set(goal.name, [goal.name, textOf(goal), goal.unit].filter(Boolean).join(" "));
  }
  return [...lines.values()].join("\n");
}
