// A found motion: what it is paid, what it looks like, how it ends.

import { agentInWords, formatCount, formatNumber } from "../data/words.ts";
import { element } from "../page/dom.ts";
import { snapshots } from "../page/snapshots.ts";
import { table } from "../page/table.ts";
import { termRow } from "../page/term_row.ts";
import type { Find } from "./data.ts";

const kEnds: Record<string, string> = {
  success: "ends in success",
  failure: "ends in failure",
  truncated: "is cut off",
  diverged: "diverges",
};

function facts({ metrics, frequency, greatest_speed, greatest_height }: Find): HTMLElement {
  const list = element("dl", { class: "facts" });
  const add = (name: string, value: number | null, unit: string, doc: string): void => {
    const text = `${formatNumber(value ?? undefined)} ${unit}`.trim();
    const term = element("dt", doc ? { title: doc } : {}, name);
    list.append(element("div", {}, term, element("dd", {}, text)));
  };
  for (const { name, unit, doc, value } of metrics) add(name.replaceAll("_", " "), value, unit, doc);
  if (frequency !== null) add("frequency", frequency, "Hz", "Of the motion.");
  add("top speed", greatest_speed, "m/s", "Of the base, from one recorded frame to the next.");
  add("greatest height", greatest_height, "m", "Of the base.");
  return list;
}

/** Why a motion is no find, in a box that nobody overlooks. */
function warning({ beyond }: Find): HTMLElement[] {
  if (beyond.length === 0) return [];
  const words =
    `The simulation has gone astray: ${beyond.join(" and ")} is beyond what the robot’s ` +
    "description calls possible. This is no find.";
  return [element("p", { class: "astray" }, words)];
}

function origin({ searches: alike, seed, episode, modules }: Find, searches: number): HTMLElement {
  const many = alike === 1 ? "one search" : `${formatCount(alike)} of ${formatCount(searches)} searches`;
  return element(
    "p",
    { class: "note" },
    `Seed ${seed}, episode ${episode}; found by ${many}.`,
    element("br"),
    agentInWords(modules),
  );
}

/** The whole episode, and what happens again and again in it. */
function pictures({ strip, repetition }: Find): HTMLElement[] {
  if (!repetition) return [snapshots(strip)];
  return [
    snapshots(strip),
    element("h3", {}, "One repetition, in the middle of the episode"),
    snapshots(repetition),
  ];
}

/** `replay` is called when the replay is asked for. */
export function findCard(find: Find, searches: number, replay: () => void): HTMLElement {
  const { terms, end, seconds, name } = find;
  const play = element("button", { type: "button", class: "text" }, "▶ Replay");
  play.addEventListener("click", replay);
  const ends = `${kEnds[end.kind] ?? end.kind} after ${formatNumber(seconds)} s: ${end.reason}`;
  const paid = terms
    .filter(({ value }) => value !== 0)
    .sort((a, b) => Math.abs(b.value) - Math.abs(a.value))
    .map((term) => termRow(term, formatNumber(term.value)));
  const words = element(
    "div",
    { class: "find-words" },
    element(
      "header",
      {},
      element("h2", {}, element("span", { class: "rank" }, name), formatNumber(find.return)),
      element("p", { class: "end", "data-kind": end.kind }, ends),
    ),
    facts(find),
    ...warning(find),
    element("p", { class: "play" }, play),
    origin(find, searches),
  );
  const pay = table(["Paid by", "", "Share", "In the episode"], paid);
  pay.classList.add("terms-table");
  return element(
    "article",
    { class: "find" },
    words,
    element("div", { class: "find-shown" }, ...pictures(find), pay),
  );
}
