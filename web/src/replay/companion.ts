// A second replay beside the first one: at the same time of its own episode, seen from the same side.

import type { Scenery } from "../data/report_data.ts";
import { byId } from "../page/dom.ts";
import type { AidSwitches } from "./aid_switches.ts";
import { durationOf, type Replay } from "./motion.ts";
import { mountStage } from "./mount_stage.ts";
import type { Stage } from "./stage.ts";
import { StageWords } from "./stage_words.ts";

/** Something that can be shown beside a replay. */
export interface Other {
  title: string;
  replay: Replay;
  scenery: Scenery;
}

export class Companion {
  private readonly host = byId("other-stage", HTMLElement);
  private readonly words = new StageWords("other-");
  private stage: Stage | undefined;
  private scenery: Scenery | undefined;
  private other: Other | undefined;

  /** `onView` is called when the user moves the second camera. */
  constructor(
    private readonly aids: AidSwitches,
    private readonly onView: (stage: Stage) => void,
  ) {}

  /** Until the first is gone from the screen, or nothing is chosen. */
  show(other: Other | undefined): void {
    this.other = other;
    this.host.hidden = other === undefined;
    this.host.parentElement?.classList.toggle("two", other !== undefined);
    if (!other) return;
    const stage = (this.stage ??= this.makeStage(other.scenery));
    if (this.scenery !== other.scenery) stage.setScenery(other.scenery);
    this.scenery = other.scenery;
    stage.show(other.replay);
    byId("other-title", HTMLElement).textContent = other.title;
    stage.canvas.setAttribute("aria-label", `The robot in ${other.title}`);
  }

  /** Of what is shown [s]; 0 where that is nothing. */
  get duration(): number {
    return this.other ? durationOf(this.other.replay) : 0;
  }

  /** What is shown, if anything is. */
  get canvases(): HTMLCanvasElement[] {
    return this.stage && this.other ? [this.stage.canvas] : [];
  }

  lookFrom(leader: Stage): void {
    if (this.stage) this.stage.view = leader.view;
  }

  setFollowing(follows: boolean): void {
    this.stage?.setFollowing(follows);
  }

  updateTheme(): void {
    this.stage?.updateTheme();
  }

  draw(): void {
    if (this.other) this.stage?.draw();
  }

  setTime(time: number): void {
    if (!this.stage || !this.other) return;
    this.stage.setTime(time);
    this.words.show(this.stage, this.other.replay, this.other.scenery.body, time, this.aids.picked);
  }

  private makeStage(scenery: Scenery): Stage {
    this.scenery = scenery;
    const stage = mountStage(scenery, this.host, () => {
      if (this.stage) this.onView(this.stage); // and not while it is made
    });
    this.aids.connect(stage);
    return stage;
  }
}
