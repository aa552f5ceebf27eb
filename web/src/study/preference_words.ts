// The user's order of behaviors as a command line.

import type { Experiment } from "./data.ts";

/** `text` as one word of a shell. */
export const quoted = (text: string): string =>
  /^[\w./:@%+,-]+$/.test(text) ? text : `'${text.replaceAll("'", `'\\''`)}'`;

/** `items` with the one at `index` moved by `steps`; as they are where that leads out of them. */
export function moved<Item>(items: readonly Item[], index: number, steps: number): Item[] {
  const result = [...items];
  const target = index + steps;
  if (target < 0 || target >= items.length) return result;
  result.splice(target, 0, ...result.splice(index, 1));
  return result;
}

/** That states the order of the groups with these indices, the best first. */
export function preferCommand(folder: string, experiment: Experiment, order: number[]): string {
  const runs = order.map((group) => {
    const typical = experiment.groups[group]?.typical ?? 0;
    return experiment.runs[typical]?.name ?? "";
  });
  return ["trainer", "prefer", folder, "--order", ...runs].map(quoted).join(" ");
}
