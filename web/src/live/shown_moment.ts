// How fast episodes are shown, and the sliders by which one goes through the one that is: under the
// robot, and beside the text that is edited.

import { byId } from "../page/dom.ts";
import { Scrubber } from "../replay/scrubber.ts";
import type { Pace, ViewSource } from "./view_source.ts";

const kWords = { play: "Go on with the episode", pause: "Hold the episode" }; // the run has its own

export class ShownMoment {
  private readonly select = byId("pace", HTMLSelectElement);
  private readonly scrubbers: Scrubber[];

  constructor(private readonly source: ViewSource) {
    this.scrubbers = ["", "editor-"].map(
      (name) =>
        new Scrubber(
          name,
          () => source.toggle(),
          (time) => source.seek(time),
          kWords,
        ),
    );
    this.select.addEventListener("change", () => this.readPace());
    this.readPace();
  }

  setPace(pace: Pace): void {
    this.select.value = String(pace);
    this.readPace();
  }

  /** Of an instant of the training there is nothing to go through. */
  show(): void {
    const { moment } = this.source;
    for (const scrubber of this.scrubbers) {
      if (!moment) {
        scrubber.setEnabled(false);
        continue;
      }
      scrubber.setInterval(moment.interval);
      scrubber.show(moment);
    }
  }

  private readPace(): void {
    const { value } = this.select;
    this.source.setPace(value === "instants" ? value : Number(value));
  }
}
