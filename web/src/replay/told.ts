// What the robot was told at a time of an episode.

import type { ToldGoal } from "../data/report_data.ts";
import { formatTick } from "../data/words.ts";

const textOf = ({ type, value }: ToldGoal): string =>
  value.map((each) => (type === "bool" ? String(each === 1) : formatTick(each))).join(", ");

/** Each goal as it was told last, in the order in which they were told first. */
export function goalsAt(goals: ToldGoal[], time: number): ToldGoal[] {
  const told = new Map<string, ToldGoal>();
  for (const goal of goals) {
    if (goal.time > time + 1e-6) break;
    told.set(goal.name, goal);
  }
  return [...told.values()];
}

/** "command 0.3, -0.1 m/s", a line for each goal. */
export const toldAt = (goals: ToldGoal[], time: number): string =>
  goalsAt(goals, time)
    .map((goal) => [goal.name, textOf(goal), goal.unit].filter(Boolean).join(" "))
    .join("\n");

const isVector = ({ type }: ToldGoal): boolean => type === "vec2" || type === "vec3";

/** Goals that are places of the world. */
export const placesIn = (goals: ToldGoal[]): ToldGoal[] =>
  goals.filter((goal) => isVector(goal) && goal.unit === "m");

/** Goals that are velocities: forward and to the left, as the robot faces, and up. */
export const velocitiesIn = (goals: ToldGoal[]): ToldGoal[] =>
  goals.filter((goal) => isVector(goal) && goal.unit === "m/s");
