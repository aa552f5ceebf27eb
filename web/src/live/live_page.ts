// All parts of the page, and what they make of what the trainer says.

import { decodeParsed, type Change, type EncodedReport, type Report } from "../data/report_data.ts";
import { docOfTask } from "../data/task_source.ts";
import { agentInWords, formatRatio } from "../data/words.ts";
import { byId, onThemeChange } from "../page/dom.ts";
import { showChanges } from "./change_list.ts";
import { GrowingCurves } from "./growing_curves.ts";
import { GrowingRecord, type EpisodeEvent } from "./growing_record.ts";
import { GraphPanel, numbersInWords } from "./graph_panel.ts";
import { History } from "./history.ts";
import { showNotice } from "./notice.ts";
import { Parameters, type Listing } from "./parameters.ts";
import { Rewards } from "./rewards.ts";
import { RobotView } from "./robot_view.ts";
import { RunPanel, type Status } from "./run_panel.ts";
import { ShownMoment } from "./shown_moment.ts";
import { TaskLines } from "./task_lines.ts";
import { TasksPanel, type PageData } from "./tasks_panel.ts";
import { ask } from "./trainer.ts";
import { Values } from "./values.ts";
import { ViewSource } from "./view_source.ts";

const kBetweenDrawings = 1000 / 30 - 4; // [ms]; a screen's own pictures do not come exactly in time
const kTracesEvery = 120; // [ms]
const kCurvesEvery = 1000; // [ms]
const kOtherTask = ["load", "unload", "swap", "rollback", "promote"]; // changes of what is shown
const kSlow = 2; // times real time: a run as slow as that is watched as it trains

/** Something that the trainer tells (docs/api.md, "Events"). */
export interface TrainerEvent {
  event: string;
}

/** Throws where the trainer cannot tell it now. */
export const readRecord = async (): Promise<Report> =>
  decodeParsed(await ask<EncodedReport>("record"));

export class LivePage {
  private readonly history = new History();
  private readonly record: GrowingRecord;
  private readonly curves: GrowingCurves;
  private readonly run: RunPanel;
  private readonly source: ViewSource;
  private readonly robot: RobotView;
  private readonly moment: ShownMoment;
  private readonly rewards = new Rewards(byId("rewards", HTMLElement));
  private readonly values = new Values(byId("values", HTMLElement));
  private readonly lines = new TaskLines(byId("lines", HTMLElement));
  private readonly parameters = new Parameters(() => void this.refreshListing());
  private readonly tasks: TasksPanel;
  private readonly graph = new GraphPanel(
    (port) => this.valueOfPort(port),
    () => void this.refreshListing(),
  );
  private lastDraw: number | undefined;
  private lastTraces = 0;
  private lastCurves = 0;
  private curvesAreOld = true;
  private heardWhileReading: EpisodeEvent[] | undefined; // may be missing in what is read

  constructor(private report: Report) {
    this.record = new GrowingRecord(report);
    this.run = new RunPanel(
      this.record,
      (action) => this.attempt(action),
      (status) => this.follow(status),
    );
    this.curves = new GrowingCurves(this.record);
    this.source = new ViewSource();
    this.robot = new RobotView(report, this.source);
    this.moment = new ShownMoment(this.source);
    this.tasks = new TasksPanel(
      this.record,
      JSON.parse(byId("page-data", HTMLElement).textContent ?? "") as PageData,
      (hash) => this.report.tasks.find((task) => task.hash === hash),
      (action) => this.attempt(action),
      () => void this.refreshListing(),
    );
    showChanges(this.record.changes);
    void this.run.follow();
    document.addEventListener("visibilitychange", () => this.source.setHidden(document.hidden));
    onThemeChange(() => (this.lastTraces = 0));
    requestAnimationFrame((now) => this.draw(now));
  }

  /** Does what the user asks for; what the trainer refuses is said on top of the page. */
  private async attempt(action: () => Promise<unknown>): Promise<void> {
    showNotice("");
    try {
      await action();
    } catch (error) {
      showNotice((error as Error).message);
    }
  }

  async begin(): Promise<void> {
    await this.run.refresh();
    await this.refreshListing();
    const { status } = this.run;
    if (status && status.speed > 0 && status.speed < kSlow) this.moment.setPace("instants");
    document.documentElement.dataset["ready"] = "true";
  }

  /** What has happened while nothing was heard. */
  async catchUp(): Promise<void> {
    await this.rereadRecord();
    await this.run.refresh();
    await this.refreshListing();
  }

  showLost(): void {
    this.run.showLost();
  }

  private async refreshListing(): Promise<void> {
    await this.attempt(async () => {
      const listing = await ask<Listing>("list");
      const isKnown = ({ hash }: { hash: string }): boolean =>
        this.report.tasks.some((task) => task.hash === hash);
      if (!listing.tasks.every(isKnown)) await this.refreshTexts();
      this.tasks.show(listing);
      await this.parameters.refresh(listing);
      await this.graph.refresh();
    });
  }

  /** Of a sensor that the task reads. */
  private valueOfPort(port: string): string | undefined {
    const { last, layout } = this.history;
    const value = layout?.values.find(({ kind, name }) => kind === "sensor" && name === port);
    return value && last ? numbersInWords(last.frame.valuesOf(value)) : undefined;
  }

  private follow(status: Status): void {
    this.source.setPaused(status.state === "paused");
    const behind = status.speed > 0 ? `the run trains at ${formatRatio(status.speed)} × real time` : "";
    byId("shown", HTMLElement).title = behind;
  }

  hear(event: TrainerEvent): void {
    if (event.event === "episode") {
      const episode = event as unknown as EpisodeEvent;
      this.heardWhileReading?.push(episode);
      this.record.add(episode, this.history.layout);
      this.curvesAreOld = true;
    } else if (event.event === "change") {
      const change = event as unknown as Change;
      this.record.addChange(change);
      if (kOtherTask.includes(change.kind)) this.source.startOver();
      this.curvesAreOld = true;
      showChanges(this.record.changes);
      void this.refreshListing();
    } else if (event.event === "missed") {
      void this.rereadRecord();
    } else if (event.event === "state") {
      void this.run.refresh();
    }
  }

  /** The texts of tasks that were loaded meanwhile, and what differs in them. */
  private async refreshTexts(): Promise<void> {
    this.report = await readRecord();
    if (this.record.takeDifferences(this.report.changes)) showChanges(this.record.changes);
  }

  private async rereadRecord(): Promise<void> {
    await this.attempt(async () => {
      const since: EpisodeEvent[] = [];
      this.heardWhileReading = since;
      await this.refreshTexts();
      this.record.read(this.report);
      for (const event of since) this.record.add(event, this.history.layout);
      if (this.heardWhileReading === since) this.heardWhileReading = undefined;
      this.curvesAreOld = true;
      showChanges(this.record.changes);
    });
  }

  private draw(now: number): void {
    requestAnimationFrame((next) => this.draw(next));
    // There are thirty frames a second; a screen may show many more.
    if (this.lastDraw !== undefined && now - this.lastDraw < kBetweenDrawings) return;
    // A page that was in the background goes on from where it was.
    const passed = Math.min(now - (this.lastDraw ?? now), 1000) / 1000;
    this.lastDraw = now;
    const shown = this.source.advance(passed);
    if (shown && shown.passed.length > 0) {
      const isOther = shown.passed.map((frame) => this.history.add(frame)).some(Boolean);
      if (isOther) this.showLayout();
      this.rewards.update(this.history);
      this.values.update(this.history);
      const { last } = this.history;
      if (last) this.lines.light((term) => this.rewards.share(last, term));
    }
    if (shown) this.robot.draw(shown, this.run.status?.state ?? "");
    this.moment.show();
    if (now - this.lastTraces > kTracesEvery) {
      this.lastTraces = now;
      this.rewards.drawTraces(this.history);
      this.values.drawTraces(this.history);
      this.tasks.showMoment(this.history);
      this.curves.drawCards();
    }
    if (this.curvesAreOld && now - this.lastCurves > kCurvesEvery) {
      [this.lastCurves, this.curvesAreOld] = [now, false];
      this.curves.draw();
      this.tasks.refreshReturns();
      this.run.drawSpark();
    }
  }

  private showLayout(): void {
    const { layout } = this.history;
    if (!layout) return;
    this.rewards.show(layout);
    this.values.show(layout);
    this.tasks.showLayout(layout);
    const task = this.report.tasks.find(({ hash }) => hash === layout.hash);
    if (!task) {
      void this.attempt(async () => {
        await this.refreshTexts();
        this.showTexts();
      });
      return;
    }
    this.showTexts();
  }

  private showTexts(): void {
    const { layout } = this.history;
    const task = this.report.tasks.find(({ hash }) => hash === layout?.hash);
    if (!layout || !task) return;
    this.lines.show(task.sources, layout);
    byId("task-doc", HTMLElement).textContent = docOfTask(task.sources[0]?.text ?? "");
    byId("lines-note", HTMLElement).textContent = `${agentInWords(this.report.modules)}`;
  }
}
