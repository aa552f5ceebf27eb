// The changes on a chart over the episodes: a line where each took effect, with its text.

import type uPlot from "uplot";

import type { Change } from "../data/report_data.ts";
import { formatCount } from "../data/words.ts";
import { element } from "../page/dom.ts";

/** Changes that took effect in the same place. */
interface Place {
  x: number; // on the axis of episodes
  changes: Change[];
}

/** Before the episode, for a change between two episodes; else at it. */
export const placeOf = ({ episode, step }: Change): number =>
  step === 0 ? episode - 0.5 : episode;

export const changeWords = ({ episode, step, text }: Change): string =>
  `episode ${formatCount(episode)}${step > 0 ? `, step ${formatCount(step)}` : ""}: ${text}`;

function placesOf(changes: Change[]): Place[] {
  const places: Place[] = [];
  for (const change of changes) {
    const x = placeOf(change);
    const last = places.at(-1);
    if (last?.x === x) last.changes.push(change);
    else places.push({ x, changes: [change] });
  }
  return places;
}

export class ChangeMarks {
  private readonly host = element("div", { class: "changes-on-chart" });
  private readonly places: Place[];

  /** `isRepeated`: they stand on another chart, too, where the keyboard reaches them. */
  constructor(changes: Change[], isRepeated = false) {
    this.places = placesOf(changes);
    for (const { changes: here } of this.places) {
      const words = here.map(changeWords).join("\n");
      const label = element("span", { class: "label", "aria-hidden": "true" }, words);
      const mark = element("button", { type: "button", "aria-label": words }, label);
      mark.className = "change";
      if (isRepeated) mark.tabIndex = -1;
      this.host.append(mark);
    }
  }

  remove(): void {
    this.host.remove();
  }

  /** Call after each drawing of `plot`. */
  place(plot: uPlot): void {
    if (this.host.parentElement !== plot.over) plot.over.prepend(this.host);
    const { min = 0, max = 0 } = plot.scales["x"] as uPlot.Scale;
    const width = plot.over.clientWidth;
    this.places.forEach(({ x }, i) => {
      const mark = this.host.children[i] as HTMLElement;
      const left = plot.valToPos(x, "x");
      mark.hidden = x < min || x > max;
      mark.style.left = `${left}px`;
      mark.classList.toggle("to-the-left", left > width / 2);
    });
  }
}
