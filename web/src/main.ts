// Builds the page from the data that it carries.

import "uplot/dist/uPlot.min.css";
import "./style/theme.css";
import "./style/page.css";
import "./style/charts.css";
import "./style/replay.css";
import "./style/timeline.css";

import { showLearner } from "./charts/learner_charts.ts";
import { LearningCurve } from "./charts/learning_curve.ts";
import { TermCurves } from "./charts/term_curves.ts";
import { ValueCharts } from "./charts/value_charts.ts";
import { decodeReport, type Recording, type Report } from "./data/report_data.ts";
import { kWindows, usualWindow } from "./data/statistics.ts";
import { tellingTime } from "./data/timeline.ts";
import { formatCount, formatNumber } from "./data/words.ts";
import { byId, element, hasWebGl, prefersReducedMotion } from "./page/dom.ts";
import { showEvaluations } from "./page/evaluations.ts";
import { showHistory } from "./page/history.ts";
import { showKeyFigures, showMasthead } from "./page/masthead.ts";
import { showProvenance, showSources } from "./page/provenance.ts";
import { settingsOf } from "./page/settings.ts";
import { fragmentOf, momentIn } from "./replay/link.ts";
import { durationOf } from "./replay/motion.ts";
import { Viewer } from "./replay/viewer.ts";
import { TimelinePanel } from "./timeline/panel.ts";

/** The charts; `replay` is called for a recording whose mark is chosen. */
function showCharts(report: Report, replay: (recording: Recording) => void): LearningCurve {
  const window = usualWindow(report.episode.length);
  const curve = new LearningCurve(
    report,
    {
      chart: byId("curve", HTMLElement),
      readout: byId("curve-readout", HTMLElement),
      key: byId("curve-key", HTMLElement),
    },
    window,
    replay,
  );
  const terms = new TermCurves(
    report,
    {
      chart: byId("terms", HTMLElement),
      legend: byId("term-legend", HTMLElement),
      caption: byId("term-caption", HTMLElement),
    },
    window,
  );
  const metrics = new ValueCharts(report, report.metrics, byId("metrics", HTMLElement), window);
  const logs = new ValueCharts(report, report.logs, byId("logs", HTMLElement), window);
  const goals = new ValueCharts(report, report.goals, byId("goals", HTMLElement), window);
  const phases = new ValueCharts(report, report.phases, byId("phases", HTMLElement), window);
  showLearner(report, byId("learner", HTMLElement));
  byId("learner-section", HTMLElement).hidden = report.learner.length === 0;
  byId("terms-section", HTMLElement).hidden = report.terms.length === 0;
  byId("metrics-section", HTMLElement).hidden = report.metrics.length === 0;
  byId("logs-section", HTMLElement).hidden = report.logs.length === 0;
  byId("goals-section", HTMLElement).hidden = report.goals.length === 0;
  byId("phases-section", HTMLElement).hidden = report.phases.length === 0;
  connectWindow(window, (chosen) => {
    curve.setWindow(chosen);
    terms.setWindow(chosen);
    metrics.setWindow(chosen);
    logs.setWindow(chosen);
    goals.setWindow(chosen);
    phases.setWindow(chosen);
  });
  return curve;
}

function connectWindow(window: number, apply: (window: number) => void): void {
  const select = byId("window", HTMLSelectElement);
  select.append(...kWindows.map((choice) => element("option", {}, String(choice))));
  select.value = String(window);
  select.addEventListener("change", () => apply(Number(select.value)));
}

function fillRecordings(report: Report, select: HTMLSelectElement): void {
  report.recordings.forEach((recording, i) => {
    const value = formatNumber(report.returns[report.episode.indexOf(recording.episode)]);
    const best = recording.best ? ", best" : "";
    const words = `${formatCount(recording.episode)} — return ${value}${best}`;
    select.append(element("option", { value: String(i) }, words));
  });
}

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

/** The timeline under the replay; without a replay it has a time of its own. */
function makeTimeline(report: Report, viewer: Viewer | undefined): TimelinePanel {
  const panel: TimelinePanel = new TimelinePanel(
    report,
    {
      section: byId("timeline-section", HTMLElement),
      rows: byId("timeline", HTMLElement),
      now: byId("timeline-now", HTMLElement),
      source: byId("timeline-source", HTMLElement),
    },
    (time) => {
      viewer?.pause();
      if (viewer) viewer.seek(time);
      else panel.setTime(time);
    },
  );
  viewer?.onTime((time) => panel.setTime(time));
  return panel;
}

/** What to show of a recording before it is played: not a robot that stands still. */
const openingOf = (recording: Recording): number =>
  recording.timeline ? tellingTime(recording.timeline) : durationOf(recording) / 2;

const kSettleTime = 200; // before the page's address follows the replay [ms]

/** The recording that the page's address leads to. */
const linkedIn = (report: Report): Recording | undefined =>
  report.recordings.find(({ episode }) => episode === momentIn(location.hash)?.episode);

/** The page's address leads to the moment at which the replay stands, and the replay to that. */
function connectLinks(
  report: Report,
  viewer: Viewer,
  chosen: HTMLSelectElement,
  replay: (recording: Recording) => void,
): void {
  const seek = (): void => viewer.seek(momentIn(location.hash)?.time ?? 0);
  let timer = 0;
  viewer.onRest((time) => {
    window.clearTimeout(timer);
    timer = window.setTimeout(() => {
      const episode = report.recordings[Number(chosen.value)]?.episode;
      if (episode) history.replaceState(null, "", fragmentOf({ episode, time }));
    }, kSettleTime);
  });
  window.addEventListener("hashchange", () => {
    const recording = linkedIn(report);
    if (!recording) return;
    replay(recording);
    seek();
  });
  if (linkedIn(report)) seek();
}

function main(): void {
  const report = decodeReport(byId("report-data", HTMLElement).textContent ?? "");
  showMasthead(report);
  byId("settings", HTMLElement).append(...settingsOf(report));
  showKeyFigures(report);
  showHistory(report);
  showEvaluations(report);
  showSources(report);
  showProvenance(report);
  const chosen = byId("recording", HTMLSelectElement);
  fillRecordings(report, chosen);
  const viewer = makeViewer(report);
  const timeline = makeTimeline(report, viewer);
  const replay = (recording: Recording): void => {
    chosen.value = String(report.recordings.indexOf(recording));
    timeline.show(recording);
    viewer?.show(recording, openingOf(recording));
    curve.select(recording);
  };
  const curve = showCharts(report, (recording) => {
    replay(recording);
    if (viewer && !prefersReducedMotion()) viewer.play();
  });
  chosen.addEventListener("change", () => {
    const recording = report.recordings[Number(chosen.value)];
    if (recording) replay(recording);
  });
  const best = report.recordings.find((recording) => recording.best);
  const first = linkedIn(report) ?? best ?? report.recordings[0];
  if (first) replay(first);
  if (viewer) connectLinks(report, viewer, chosen, replay);
  document.documentElement.dataset["ready"] = "true";
}

main();
