// The replay of the report, another one beside it where that is wanted, and their timelines.

import type { Recording, Report } from "./data/report_data.ts";
import { tellingTime } from "./data/timeline.ts";
import { formatCount, formatNumber } from "./data/words.ts";
import { byId, element, hasWebGl } from "./page/dom.ts";
import { fragmentOf, momentIn } from "./replay/link.ts";
import { durationOf } from "./replay/motion.ts";
import { Viewer } from "./replay/viewer.ts";
import { TimelinePanel } from "./timeline/panel.ts";

const kSettleTime = 200; // before the page's address follows the replay [ms]

/** What to show of a recording before it is played: not a robot that stands still. */
const openingOf = (recording: Recording): number =>
  recording.timeline ? tellingTime(recording.timeline) : durationOf(recording) / 2;

/** The viewer, or a message in its place where there is nothing to show or no way to show it. */
function makeViewer(report: Report): Viewer | undefined {
  const refuse = (message: string): undefined => {
    byId("stage-message", HTMLElement).textContent = message;
    byId("replay", HTMLElement).classList.add("unavailable");
    return undefined;
  };
  if (!report.run["robot"]) return refuse("Without a robot there is nothing to replay.");
  if (report.recordings.length === 0) return refuse("No episode has been recorded yet.");
  if (!hasWebGl()) {
    return refuse(
      "This browser offers no WebGL, so the replay cannot be drawn here. " +
        "Hardware acceleration can be switched on in the browser’s settings. " +
        "The curves are complete without it.",
    );
  }
  return new Viewer(report);
}

export class Replays {
  readonly viewer: Viewer | undefined;
  private readonly chosen = byId("recording", HTMLSelectElement);
  private readonly other = byId("other", HTMLSelectElement);
  private readonly timeline: TimelinePanel;
  private readonly otherTimeline: TimelinePanel;
  private time = 0;

  /** `onShow` is called with the recording that is replayed from then on. */
  constructor(
    private readonly report: Report,
    private readonly onShow: (recording: Recording) => void,
  ) {
    this.fillSelects();
    this.viewer = makeViewer(report);
    this.timeline = this.makeTimeline("timeline", byId("timeline-source", HTMLElement));
    this.otherTimeline = this.makeTimeline("other-timeline");
    this.viewer?.onTime((time) => this.setTime(time));
    this.viewer?.onPick((link) => {
      for (const panel of [this.timeline, this.otherTimeline]) panel.pick(link);
    });
    this.chosen.addEventListener("change", () => this.showChosen());
    this.other.addEventListener("change", () => this.showOther());
  }

  show(recording: Recording): void {
    this.chosen.value = String(this.report.recordings.indexOf(recording));
    this.time = 0;
    this.viewer?.show(recording, openingOf(recording), this.titleOf(recording));
    this.showOther();
    this.onShow(recording);
  }

  /** Begins with what the page's address leads to, or with the best. */
  open(): void {
    const { recordings } = this.report;
    const linked = this.linked();
    const first = linked ?? recordings.find(({ best }) => best) ?? recordings[0];
    if (first) this.show(first);
    if (this.viewer) this.connectLinks(this.viewer);
    if (linked) this.viewer?.seek(momentIn(location.hash)?.time ?? 0);
  }

  private fillSelects(): void {
    this.other.append(element("option", { value: "" }, "nothing"));
    this.report.recordings.forEach((recording, i) => {
      const best = recording.best ? ", best" : "";
      const words = `${formatCount(recording.episode)} — return ${this.returnOf(recording)}${best}`;
      for (const select of [this.chosen, this.other]) {
        select.append(element("option", { value: String(i) }, words));
      }
    });
    byId("other-label", HTMLElement).hidden = this.report.recordings.length < 2;
  }

  private returnOf({ episode }: Recording): string {
    return formatNumber(this.report.returns[this.report.episode.indexOf(episode)]);
  }

  private titleOf(recording: Recording): string {
    return `episode ${formatCount(recording.episode)}, return ${this.returnOf(recording)}`;
  }

  /** Without a replay the timelines have a time of their own. */
  private makeTimeline(name: string, source?: HTMLElement): TimelinePanel {
    const parts = {
      section: byId(`${name}-section`, HTMLElement),
      rows: byId(name, HTMLElement),
      now: byId(`${name}-now`, HTMLElement),
      ...(source && { source }),
    };
    return new TimelinePanel(this.report, parts, (time) => {
      this.viewer?.pause();
      if (this.viewer) this.viewer.seek(time);
      else this.setTime(time);
    });
  }

  private setTime(time: number): void {
    this.time = time;
    this.timeline.setTime(time);
    this.otherTimeline.setTime(time);
  }

  private get recording(): Recording | undefined {
    return this.report.recordings[Number(this.chosen.value)];
  }
  private get beside(): Recording | undefined {
    return this.other.value === "" ? undefined : this.report.recordings[Number(this.other.value)];
  }

  private showChosen(): void {
    if (this.recording) this.show(this.recording);
  }

  private showOther(): void {
    const { recording, beside, report } = this;
    const title = beside ? this.titleOf(beside) : "";
    document.querySelector("main")?.classList.toggle("comparing", beside !== undefined);
    this.viewer?.showBeside(beside && { title, replay: beside, scenery: report });
    byId("other-timeline-heading", HTMLElement).textContent = title;
    if (recording) this.timeline.show(recording, beside?.timeline);
    if (beside) this.otherTimeline.show(beside, recording?.timeline);
    else this.otherTimeline.hide();
    this.setTime(this.time);
  }

  /** The recording that the page's address leads to. */
  private linked(): Recording | undefined {
    const moment = momentIn(location.hash);
    return this.report.recordings.find(({ episode }) => episode === moment?.episode);
  }

  /** The page's address leads to the moment at which the replay stands, and the replay to that. */
  private connectLinks(viewer: Viewer): void {
    let timer = 0;
    viewer.onRest((time) => {
      window.clearTimeout(timer);
      timer = window.setTimeout(() => {
        const episode = this.recording?.episode;
        if (episode) history.replaceState(null, "", fragmentOf({ episode, time }));
      }, kSettleTime);
    });
    window.addEventListener("hashchange", () => {
      const recording = this.linked();
      if (!recording) return;
      this.show(recording);
      viewer.seek(momentIn(location.hash)?.time ?? 0);
    });
  }
}
