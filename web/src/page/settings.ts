// What was set for a run, and how to make it again.

import type { Setting } from "../data/report_data.ts";
import { element } from "./dom.ts";

interface Made {
  settings: Setting[];
  command: string;
}

/** "task.fall_penalty = 8.0", one after the other; nothing where nothing was set. */
export function settingWords({ settings }: Pick<Made, "settings">): HTMLElement[] {
  if (settings.length === 0) return [];
  const words = settings.flatMap(({ name, value, origin }, i) => [
    i === 0 ? "" : ", ",
    element("code", { title: origin }, `${name} = ${value}`),
  ]);
  return [element("div", { class: "settings note" }, ...words)];
}

/** The settings and the command; nothing of a run that did not write them down. */
export function settingsOf(made: Made): HTMLElement[] {
  if (made.command === "") return settingWords(made);
  const command = element("p", { class: "settings note" }, element("code", {}, made.command));
  return [...settingWords(made), command];
}
