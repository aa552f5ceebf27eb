// The groups of behaviors in which the runs ended, a card each.

import { mean, range } from "../data/estimate.ts";
import { element } from "../page/dom.ts";
import { snapshots } from "../page/snapshots.ts";
import type { Experiment, Group } from "./data.ts";
import { colorOf, shareOf } from "./words.ts";

/** Which episode stands for the group. */
function episodeOf(experiment: Experiment, group: Group): string {
  const { seed = 0 } = experiment.runs[group.typical] ?? {};
  return `seed ${seed}, episode ${group.recording?.episode}`;
}

export const titleOf = (experiment: Experiment, group: Group): string =>
  `${experiment.name}, group ${group.name}: ${episodeOf(experiment, group)}`;

export interface GroupActions {
  emphasize(runs: number[]): void; // lets the curves of these runs stand out; all, if none
  replay(group: Group, title: string): void;
}

export class GroupCards {
  readonly element = element("div", { class: "groups" });
  private readonly heads: HTMLElement[] = [];
  private kept: Group | undefined; // whose curves stand out while no card is pointed at

  constructor(
    private readonly experiment: Experiment,
    private readonly actions: GroupActions,
  ) {
    experiment.groups.forEach((group, i) => this.element.append(this.card(group, i)));
  }

  /** Pointing at a card lets its curves stand out; a click on its head keeps them so. */
  private card(group: Group, index: number): HTMLElement {
    const head = this.head(group, index);
    const words = element("div", {}, head, this.sentence(group), figures(group));
    const card = element("article", { class: "group" }, words);
    card.addEventListener("pointerenter", () => this.actions.emphasize(group.runs));
    card.addEventListener("pointerleave", () => this.actions.emphasize(this.kept?.runs ?? []));
    if (group.recording) words.append(this.replayButton(group));
    if (group.strip) card.append(snapshots(group.strip));
    return card;
  }

  private head(group: Group, index: number): HTMLElement {
    const swatch = element("span", { class: "swatch", "aria-hidden": "true" });
    swatch.style.background = `var(${colorOf(index)})`;
    const head = element(
      "button",
      { type: "button", class: "group-head", "aria-pressed": "false" },
      swatch,
      element("strong", {}, `Group ${group.name}`),
      element("span", { class: "note" }, shareOf(group)),
    );
    head.addEventListener("click", () => {
      this.kept = this.kept === group ? undefined : group;
      this.heads.forEach((other) => {
        other.setAttribute("aria-pressed", String(this.kept === group && other === head));
      });
      this.actions.emphasize(this.kept?.runs ?? []);
    });
    this.heads.push(head);
    return head;
  }

  private replayButton(group: Group): HTMLElement {
    const what = episodeOf(this.experiment, group);
    const play = element("button", { type: "button", class: "text" }, "Replay");
    play.addEventListener("click", () => {
      this.actions.replay(group, titleOf(this.experiment, group));
    });
    return element("p", { class: "note" }, play, ` of ${what}`);
  }

  /** What people wrote, or where to write it. */
  private sentence(group: Group): HTMLElement {
    if (group.sentences.length > 0) {
      return element("p", { class: "sentence" }, group.sentences.join(" "));
    }
    const run = this.experiment.runs[group.typical]?.name ?? "";
    return element(
      "p",
      { class: "note" },
      "Not described yet. Watch it, and add to groups.toml: ",
      element("code", {}, `"${run}" = "What it does."`),
    );
  }
}

function figures(group: Group): HTMLElement {
  const list = element("dl", { class: "facts" });
  const add = (name: string, value: string, from: string): void => {
    const words = element("dd", {}, value);
    if (from) words.append(element("span", { class: "note" }, ` ${from}`));
    list.append(element("div", {}, element("dt", {}, name), words));
  };
  add("Final return", mean(group.final_return), range(group.final_return));
  for (const { name, unit, value } of group.metrics) {
    add(name, `${mean(value)} ${unit}`.trim(), range(value));
  }
  return list;
}
