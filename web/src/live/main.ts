// The page on which a run is watched and tuned while it learns.

import "uplot/dist/uPlot.min.css";
import "../style/theme.css";
import "../style/page.css";
import "../style/charts.css";
import "../style/replay.css";
import "../style/live_rewards.css";
import "../style/live_values.css";
import "../style/live_tune.css";
import "katex/dist/katex.min.css";
import "../style/editor.css";
import "../style/graph.css";
import "../style/live.css"; // last: it says what becomes of all on a narrow screen

import { changeWords } from "../charts/change_marks.ts";
import { decodeParsed, type Change, type EncodedReport, type Report } from "../data/report_data.ts";
import { docOfTask } from "../data/task_source.ts";
import { agentInWords, formatRatio } from "../data/words.ts";
import { withDifference } from "../page/difference.ts";
import { byId, element, onThemeChange } from "../page/dom.ts";
import { GrowingCurves } from "./growing_curves.ts";
import { GrowingRecord, type EpisodeEvent } from "./growing_record.ts";
import { GraphPanel, numbersInWords } from "./graph_panel.ts";
import { History } from "./history.ts";
import { Parameters, type Listing } from "./parameters.ts";
import { Rewards } from "./rewards.ts";
import { RobotView } from "./robot_view.ts";
import { RunPanel, type Status } from "./run_panel.ts";
import { TaskLines } from "./task_lines.ts";
import { TasksPanel, type PageData } from "./tasks_panel.ts";
import { addressOf, ask, LastingSocket } from "./trainer.ts";
import { Values } from "./values.ts";
import { ViewSource, type Pace } from "./view_source.ts";

const kBetweenDrawings = 1000 / 30 - 4; // [ms]; a screen's own pictures do not come exactly in time
const kStatusEvery = 1000; // [ms]
const kTracesEvery = 120; // [ms]
const kCurvesEvery = 1000; // [ms]
const kMostChanges = 100; // of those that are listed
const kOtherTask = ["load", "unload", "swap", "rollback", "promote"]; // changes of what is shown
const kSlow = 2; // times real time: a run as slow as that is watched as it trains

interface TrainerEvent {
  event: string;
}

class LivePage {
  private readonly history = new History();
  private readonly record: GrowingRecord;
  private readonly curves: GrowingCurves;
  private readonly run: RunPanel;
  private readonly source: ViewSource;
  private readonly robot: RobotView;
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
    this.tasks = new TasksPanel(
      this.record,
      JSON.parse(byId("page-data", HTMLElement).textContent ?? "") as PageData,
      (hash) => this.report.tasks.find((task) => task.hash === hash),
      (action) => this.attempt(action),
      () => void this.refreshListing(),
    );
    this.choosePace();
    this.showChanges();
    window.setInterval(() => void this.refreshStatus(), kStatusEvery);
    document.addEventListener("visibilitychange", () => this.source.setHidden(document.hidden));
    onThemeChange(() => (this.lastTraces = 0));
    requestAnimationFrame((now) => this.draw(now));
  }

  private choosePace(): void {
    const select = byId("pace", HTMLSelectElement);
    const paceOf = (word: string): Pace => (word === "instants" ? word : Number(word));
    select.addEventListener("change", () => this.source.setPace(paceOf(select.value)));
    this.source.setPace(paceOf(select.value));
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
    await this.refreshStatus();
    await this.refreshListing();
    const { status } = this.run;
    if (status && status.speed > 0 && status.speed < kSlow) this.watchInstants();
    document.documentElement.dataset["ready"] = "true";
  }

  /** What has happened while nothing was heard. */
  async catchUp(): Promise<void> {
    await this.rereadRecord();
    await this.refreshStatus();
    await this.refreshListing();
  }

  showLost(): void {
    this.run.showLost();
  }

  private watchInstants(): void {
    byId("pace", HTMLSelectElement).value = "instants";
    this.source.setPace("instants");
  }

  private async refreshStatus(): Promise<void> {
    if (document.hidden) return;
    try {
      await this.run.refresh();
    } catch {
      this.run.showLost();
    }
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
      this.showChanges();
      void this.refreshListing();
    } else if (event.event === "missed") {
      void this.rereadRecord();
    } else if (event.event === "state") {
      void this.refreshStatus();
    }
  }

  /** The texts of tasks that were loaded meanwhile, and what differs in them. */
  private async refreshTexts(): Promise<void> {
    this.report = await readRecord();
    if (this.record.takeDifferences(this.report.changes)) this.showChanges();
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
      this.showChanges();
    });
  }

  private showChanges(): void {
    const host = byId("changes", HTMLElement);
    const changes = this.record.changes.slice(-kMostChanges).reverse();
    const item = (change: Change): HTMLElement =>
      element("li", {}, ...withDifference(changeWords(change), change));
    host.replaceChildren(...changes.map(item));
    if (changes.length === 0) host.append(element("li", { class: "note" }, "Nothing was changed yet."));
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
    if (now - this.lastTraces > kTracesEvery) {
      this.lastTraces = now;
      this.rewards.drawTraces(this.history);
      this.values.drawTraces(this.history);
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

/** On top of the page; "" takes it away. */
function showNotice(words: string): void {
  const notice = byId("notice", HTMLElement);
  notice.textContent = words;
  notice.hidden = words === "";
}

const readRecord = async (): Promise<Report> => decodeParsed(await ask<EncodedReport>("record"));

/** What happens is heard before the record is read, so that nothing falls in between. */
function main(): void {
  byId("report-link", HTMLAnchorElement).href = addressOf("/report");
  let page: LivePage | undefined;
  const heard: TrainerEvent[] = [];
  let isReading = false; // the connection may be lost and opened again meanwhile
  const begin = async (): Promise<void> => {
    if (isReading) return;
    isReading = true;
    const report = await readRecord().catch((error: Error) => showNotice(error.message));
    isReading = false;
    if (!report) {
      window.setTimeout(() => void begin(), kStatusEvery);
      return;
    }
    showNotice("");
    const begun = new LivePage(report);
    for (const event of heard.splice(0)) begun.hear(event);
    page = begun;
    await begun.begin();
  };
  new LastingSocket("/api/events", {
    onOpen: () => void (page ? page.catchUp() : begin()),
    onLost: () => page?.showLost(),
    onMessage: (data) => {
      const event = JSON.parse(data as string) as TrainerEvent;
      if (page) page.hear(event);
      else heard.push(event);
    },
  });
}

main();
