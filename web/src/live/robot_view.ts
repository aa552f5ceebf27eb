// The robot in the picture, and the words around it.

import type { Scenery } from "../data/report_data.ts";
import { formatCount, formatRatio } from "../data/words.ts";
import { byId, hasWebGl, onThemeChange } from "../page/dom.ts";
import { AidSwitches } from "../replay/aid_switches.ts";
import { jointsInWords } from "../replay/joints.ts";
import { mountStage } from "../replay/mount_stage.ts";
import type { Stage } from "../replay/stage.ts";
import { placeInWords } from "../replay/stage_words.ts";
import { forcesIn, goalsIn, poseSize, torquesIn, type Clip, type Frame } from "./view_frames.ts";
import type { Shown, ViewSource } from "./view_source.ts";
import { goalsInWords } from "./value_words.ts";

/** The poses of all frames of an episode, as the stage takes them. */
function motionOf(clip: Clip): { frames: number; interval: number; poses: Float32Array } {
  const size = poseSize(clip.layout);
  const poses = new Float32Array(clip.frames * size);
  for (let i = 0; i < clip.frames; ++i) {
    // The last frame of a clip comes at the episode's end, which need not be a whole interval on.
    const frame = i * clip.layout.size + 3;
    poses.set(clip.numbers.subarray(frame, frame + size), i * size);
  }
  return { frames: clip.frames, interval: clip.interval, poses };
}

export class RobotView {
  private readonly stage: Stage | undefined;
  private readonly place = byId("place", HTMLElement);
  private readonly told = byId("told", HTMLElement);
  private readonly joints = byId("joints", HTMLElement);
  private readonly words = byId("shown", HTMLElement);
  private readonly aids = new AidSwitches(() => (this.mustDraw = true));
  private clip: Clip | undefined;
  private mustDraw = true;
  private wasHeld = false;

  constructor(
    private readonly scenery: Scenery,
    private readonly source: ViewSource,
  ) {
    this.stage = this.makeStage(scenery);
  }

  private makeStage(scenery: Scenery): Stage | undefined {
    if (!hasWebGl()) {
      byId("robot", HTMLElement).classList.add("unavailable");
      byId("stage-message", HTMLElement).textContent =
        "This browser offers no WebGL, so the robot cannot be drawn here.";
      return undefined;
    }
    const redraw = (): void => void (this.mustDraw = true);
    const stage = mountStage(scenery, byId("stage", HTMLElement), redraw, redraw);
    stage.canvas.setAttribute("aria-label", "The robot as it is now");
    this.aids.connect(stage);
    onThemeChange(() => {
      stage.updateTheme();
      redraw();
    });
    const follow = byId("follow", HTMLInputElement);
    follow.addEventListener("change", () => {
      stage.setFollowing(follow.checked);
      redraw();
    });
    byId("reset-view", HTMLButtonElement).addEventListener("click", () => stage.resetView());
    return stage;
  }

  /** Draws what is shown, if that or the camera has changed. */
  draw({ frame, time, passed }: Shown, state: string): void {
    const isNew = passed.length > 0;
    const { isHeld } = this.source;
    if (isNew || isHeld !== this.wasHeld) this.describe(frame, state);
    this.wasHeld = isHeld;
    if (!this.stage?.isInSight) return;
    if (!(isNew || this.mustDraw || this.source.isPlaying)) return;
    const { clip } = frame;
    if (clip.layout.links === 0) return;
    if (!clip.isEpisode) {
      this.stage.showInstant(frame.poses);
    } else {
      if (clip !== this.clip) this.showEpisode(this.stage, clip);
      this.stage.setTime(time);
    }
    if (clip.layout !== this.clip?.layout) this.offerAids(frame);
    this.clip = clip;
    const { contacts } = frame;
    const touches = (link: number): boolean => contacts[link] === 1;
    this.stage.setInstant({ touches, forces: forcesIn(frame), goals: goalsIn(frame) });
    this.stage.draw();
    this.showJoints(this.stage, frame);
    this.mustDraw = false;
  }

  private showEpisode(stage: Stage, clip: Clip): void {
    stage.continueWith(motionOf(clip));
  }

  private offerAids(frame: Frame): void {
    this.aids.offer({ body: this.scenery.body, hasContacts: true, goals: goalsIn(frame) });
  }

  /** Of the picked link; torques where the task reads them. */
  private showJoints(stage: Stage, frame: Frame): void {
    const { picked } = this.aids;
    this.joints.textContent =
      picked === undefined
        ? ""
        : jointsInWords(this.scenery.body, picked, stage.now, torquesIn(frame));
  }

  private describe(frame: Frame, state: string): void {
    const [x = 0, y = 0, z = 0] = frame.poses;
    this.place.textContent = placeInWords([x, y, z]);
    this.told.textContent = goalsInWords(frame);
    const moment = `Episode ${formatCount(frame.clip.episode)}, ${frame.time.toFixed(2)} s`;
    this.words.textContent = [moment, this.howShown(state)].join("  ·  ");
    const hasLinks = frame.clip.layout.links > 0;
    byId("stage-message", HTMLElement).textContent = hasLinks ? "" : "There is no robot to be seen here.";
    if (!hasLinks) this.place.textContent = "";
  }

  private howShown(state: string): string {
    if (state === "paused") return "the run is paused here";
    if (this.source.showsInstants) return "this instant of the training";
    if (this.source.isHeld) return "held at this moment; the training goes on";
    const rate = this.source.rate;
    const pace = rate === 1 ? "in real time" : `at ${rate < 1 ? rate : formatRatio(rate)} × real time`;
    return `a whole episode ${pace}; the training is ahead`;
  }
}
