// What the user calls better: the groups of behaviors in an order of one's own, and what followed
// from the preferences that were stated before.

import { withUnit } from "../data/words.ts";
import { element } from "../page/dom.ts";
import { row, table } from "../page/table.ts";
import type { Experiment, Preferences } from "./data.ts";
import { moved, preferCommand } from "./preference_words.ts";
import { colorOf } from "./words.ts";

/** The groups in an order that buttons change, and the command that states it. */
class GroupOrder {
  readonly element: HTMLElement;
  private readonly list = element("ol", { class: "order" });
  private readonly command = element("code", {});
  private order: number[];
  private readonly left = new Set<number>(); // groups about which nothing is said

  constructor(
    private readonly experiment: Experiment,
    private readonly folder: string,
  ) {
    this.order = experiment.groups.map((_, group) => group);
    const copy = element("button", { type: "button", class: "text" }, "Copy");
    copy.addEventListener("click", () => void this.copy(copy));
    this.element = element(
      "div",
      { class: "preferences" },
      element("p", { class: "note" }, "Put the groups in order, best first; uncheck those you are not sure about:"),
      this.list,
      element("p", { class: "note" }, "Then fit the task’s weights: ", this.command, " ", copy),
    );
    this.show();
  }

  private show(): void {
    this.list.replaceChildren(...this.order.map((group, place) => this.item(group, place)));
    this.showCommand();
  }

  private showCommand(): void {
    const order = this.order.filter((group) => !this.left.has(group));
    this.command.textContent =
      order.length < 2 ? "–" : preferCommand(this.folder, this.experiment, order);
  }

  private nameOf(group: number): string {
    return `Group ${this.experiment.groups[group]?.name ?? ""}`;
  }

  private item(group: number, place: number): HTMLElement {
    const swatch = element("span", { class: "swatch", "aria-hidden": "true" });
    swatch.style.background = `var(${colorOf(group)})`;
    const [sentence = ""] = this.experiment.groups[group]?.sentences ?? [];
    return element(
      "li",
      {},
      this.button(group, place, -1),
      this.button(group, place, 1),
      element("label", {}, this.tick(group), swatch, this.nameOf(group)),
      element("span", { class: "note" }, sentence),
    );
  }

  private tick(group: number): HTMLElement {
    const made = element("input", { type: "checkbox" });
    made.checked = !this.left.has(group);
    made.addEventListener("change", () => {
      if (made.checked) this.left.delete(group);
      else this.left.add(group);
      this.showCommand();
    });
    return made;
  }

  /** Moves the group, and keeps the focus on its button, so that a key can be pressed again. */
  private button(group: number, place: number, steps: 1 | -1): HTMLElement {
    const way = steps < 0 ? "better" : "worse";
    const label = `${this.nameOf(group)} is ${way}`;
    const made = element("button", { type: "button", "aria-label": label, title: way });
    made.textContent = steps < 0 ? "↑" : "↓";
    made.disabled = place + steps < 0 || place + steps >= this.order.length;
    made.addEventListener("click", () => {
      this.order = moved(this.order, place, steps);
      this.show();
      this.focus(place + steps, steps);
    });
    return made;
  }

  private focus(place: number, steps: 1 | -1): void {
    const buttons = this.list.children[place]?.querySelectorAll("button") ?? [];
    const [up, down] = steps < 0 ? buttons : [...buttons].reverse();
    (up?.disabled ? down : up)?.focus();
  }

  /** Where the clipboard is closed to pages, the command is selected instead. */
  private async copy(button: HTMLElement): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.command.textContent ?? "");
      button.textContent = "Copied";
    } catch {
      getSelection()?.selectAllChildren(this.command);
    }
  }
}

const percent = (probability: number, holds: boolean): string =>
  `${(100 * probability).toFixed(0)} % ${holds ? "✓" : "✗"}`;

/** A weight as it stands in a task; one that was computed, to two digits. */
const exactly = String;
const roughly = (value: number): string => String(Number(value.toPrecision(2)));

function verdict({ preferences, is_consistent }: Preferences): string {
  const held = preferences.filter(({ holds }) => holds.before).length;
  const holding = preferences.filter(({ holds }) => holds.after).length;
  const words = `Of ${preferences.length} preferences, ${held} hold with the current weights, ${holding} with the new ones.`;
  if (preferences.some((each) => each.is_contradicted)) {
    return `${words} Some contradict each other.`;
  }
  return is_consistent ? words : `${words} No weights within their ranges explain all of them.`;
}

/** What the stated preferences say of the weights. */
function outcome(experiment: Experiment, fitted: Preferences): HTMLElement {
  const short = (name: string): string => name.replace(`${experiment.name}/`, "");
  const weights = fitted.weights.map(({ name, unit, before, after, low, high }) =>
    row([
      withUnit({ name, unit }),
      exactly(before),
      exactly(after),
      `${roughly(low)} … ${roughly(high)}`,
    ]),
  );
  const preferences = fitted.preferences.map(({ better, worse, is_tie, probability, holds }) =>
    row([
      `${short(better)} ${is_tie ? "as good as" : "over"} ${short(worse)}`,
      percent(probability.before, holds.before),
      percent(probability.after, holds.after),
    ]),
  );
  return element(
    "div",
    { class: "outcome" },
    element("p", {}, verdict(fitted)),
    element(
      "div",
      { class: "first-row" },
      table(["Preference", "Now", "New"], preferences),
      table(["Weight", "Now", "New", "Likely"], weights),
    ),
    ...fitted.notes.map((note) => element("p", { class: "note" }, note)),
  );
}

/** Nothing where there is neither a choice nor a preference. */
export function showPreferences(experiment: Experiment, folder: string): HTMLElement[] {
  const parts: HTMLElement[] = [];
  if (experiment.groups.length > 1) parts.push(new GroupOrder(experiment, folder).element);
  if (experiment.preferences) parts.push(outcome(experiment, experiment.preferences));
  return parts.length > 0 ? [element("h3", {}, "Your preferences"), ...parts] : [];
}
