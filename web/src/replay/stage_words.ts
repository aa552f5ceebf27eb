// The words in the corners of a stage: where the robot is, what it was told, and how its joints are.

import type { BodyLink } from "../data/report_data.ts";
import { sampleAt } from "../data/timeline.ts";
import { formatThousandths } from "../data/words.ts";
import { byId } from "../page/dom.ts";
import { jointsInWords } from "./joints.ts";
import type { Replay } from "./motion.ts";
import type { Stage } from "./stage.ts";
import { toldAt } from "./told.ts";

export const placeInWords = (place: number[]): string => {
  const [x, y, z] = place.map(formatThousandths);
  return `x ${x}  y ${y}  z ${z} m`;
};

/** "phase lift" */
function phaseAt({ timeline }: Replay, time: number): string {
  if (!timeline?.phases) return "";
  const { names, values } = timeline.phases;
  const name = names[values[sampleAt(timeline, time)] ?? -1];
  return name ? `phase ${name}` : "";
}

export class StageWords {
  private readonly place: HTMLElement;
  private readonly told: HTMLElement;
  private readonly joints: HTMLElement;

  /** `prefix`: of the ids of the elements. */
  constructor(prefix = "") {
    [this.place, this.told, this.joints] = ["place", "told", "joints"].map((id) =>
      byId(prefix + id, HTMLElement),
    ) as [HTMLElement, HTMLElement, HTMLElement];
  }

  show(stage: Stage, replay: Replay, body: BodyLink[], time: number, picked: number | undefined): void {
    this.place.textContent = placeInWords(stage.place);
    const told = [toldAt(replay.goals ?? [], time), phaseAt(replay, time)];
    this.told.textContent = told.filter(Boolean).join("\n");
    this.joints.textContent = picked === undefined ? "" : jointsInWords(body, picked, stage.now);
  }
}
