// What the text in the editor would have paid for a recorded episode.

import { endInWords, formatCount, formatNumber } from "../data/words.ts";
import { byId, element } from "../page/dom.ts";
import { row, table } from "../page/table.ts";
import { ask, type Json } from "./trainer.ts";

const kQuiet = 400; // without another edit, before an episode is judged [ms]

/** What a task says of an episode. */
export interface Judgment {
  return: number;
  end_kind: string;
  end_reason: string;
  end_time: number;
  terms: Record<string, number>;
  metrics: Record<string, number>;
}

interface Rescored {
  episode: number;
  old: Judgment;
  new: Judgment;
  first_difference: { time: number; what: string } | null;
  caveats: string[];
  recorded: number[];
}

/** A number that both tasks may have; undefined where one has none of this name. */
export interface Compared {
  name: string;
  kind: "return" | "term" | "metric";
  old: number | undefined;
  new: number | undefined;
}

export function comparedOf(old: Judgment, edited: Judgment): Compared[] {
  const all = (kind: "term" | "metric", before: Record<string, number>, after: Record<string, number>) =>
    [...new Set([...Object.keys(before), ...Object.keys(after)])].map(
      (name): Compared => ({ name, kind, old: before[name], new: after[name] }),
    );
  return [
    { name: "return", kind: "return", old: old.return, new: edited.return },
    ...all("term", old.terms, edited.terms),
    ...all("metric", old.metrics, edited.metrics),
  ];
}

function differenceInWords({ kind, old, new: edited }: Compared): string {
  if (kind === "metric" && (old === undefined || edited === undefined)) return "";
  const difference = (edited ?? 0) - (old ?? 0); // a term that is not there pays nothing
  if (difference === 0) return "0";
  return difference > 0 ? `+${formatNumber(difference)}` : formatNumber(difference);
}

const endOf = ({ end_kind: kind, end_reason: reason, end_time: time }: Judgment): string =>
  `${endInWords({ kind, reason })}, after ${time.toFixed(2)} s`;

export class WhatIf {
  private readonly host = byId("what-if-result", HTMLElement);
  private readonly words = byId("what-if-words", HTMLElement);
  private readonly select = byId("what-if-episode", HTMLSelectElement);
  private readonly follow = byId("what-if-follow", HTMLInputElement);
  private timer = 0;
  private isAsking = false;
  private mustAskAgain = false;

  /** `requestOf`: file and text of what is edited now. */
  constructor(private readonly requestOf: () => Json) {
    byId("what-if-now", HTMLButtonElement).addEventListener("click", () => void this.judge());
    this.select.addEventListener("change", () => void this.judge());
    this.follow.addEventListener("change", () => this.noteEdit());
  }

  /** The text is another one, and has no errors. */
  noteEdit(): void {
    if (!this.follow.checked) return;
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.judge(), kQuiet);
  }

  private async judge(): Promise<void> {
    if (this.isAsking) {
      this.mustAskAgain = true;
      return;
    }
    this.isAsking = true;
    this.words.textContent = "is being judged …";
    const episode = this.select.value === "" ? {} : { episode: Number(this.select.value) };
    try {
      this.show(await ask<Rescored & Json>("rescore", { ...this.requestOf(), ...episode }));
    } catch (error) {
      this.words.textContent = "cannot be judged";
      this.host.replaceChildren(element("pre", { class: "refusal" }, (error as Error).message));
    }
    this.isAsking = false;
    if (!this.mustAskAgain) return;
    this.mustAskAgain = false;
    await this.judge();
  }

  private show({ episode, old, new: edited, first_difference: first, ...more }: Rescored): void {
    this.fillEpisodes(more.recorded, episode);
    const difference = first
      ? `the two first differ after ${first.time.toFixed(2)} s, in ${first.what}`
      : "no difference";
    this.words.textContent = `episode ${formatCount(episode)}: ${difference}`;
    const rows = comparedOf(old, edited).map((compared) => {
      const numbers = [compared.old, compared.new].map(formatNumber);
      const made = row([compared.name, ...numbers, differenceInWords(compared)]);
      made.dataset["whatIf"] = compared.name;
      if (compared.kind === "return") made.classList.add("sum");
      return made;
    });
    rows.push(row(["end", endOf(old), endOf(edited), ""]));
    const notes = element(
      "details",
      {},
      element("summary", {}, "What this does not say"),
      element("ul", {}, ...more.caveats.map((caveat) => element("li", { class: "note" }, caveat))),
    );
    this.host.replaceChildren(table(["", "task of the episode", "edited text", "difference"], rows), notes);
  }

  private fillEpisodes(recorded: number[], shown: number): void {
    const known = [...this.select.options].map(({ value }) => Number(value));
    if (known.length !== recorded.length || known.some((number, i) => number !== recorded[i])) {
      const options = recorded.map((number) =>
        element("option", { value: String(number) }, formatCount(number)),
      );
      this.select.replaceChildren(...options);
    }
    this.select.value = String(shown);
  }
}
