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
import { byId, element, prefersReducedMotion } from "./page/dom.ts";
import { showEvaluations } from "./page/evaluations.ts";
import { showHistory } from "./page/history.ts";
import { showKeyFigures, showMasthead } from "./page/masthead.ts";
import { showProvenance, showSources } from "./page/provenance.ts";
import { settingsOf } from "./page/settings.ts";
import { Replays } from "./replays.ts";

/** The charts; `replay` is called for a recording whose mark is chosen. */
function showCharts(report: Report, replay: (recording: Recording) => void): LearningCurve {
  const window = usualWindow(report.episode.length);
  const curve = new LearningCurve(
    report,
    {
      chart: byId("curve", HTMLElement),
      readout: byId("curve-readout", HTMLElement),
      key: byId("curve-key", HTMLElement),
      exports: byId("curve-export", HTMLElement),
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
      exports: byId("terms-export", HTMLElement),
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

function main(): void {
  const report = decodeReport(byId("report-data", HTMLElement).textContent ?? "");
  showMasthead(report);
  byId("settings", HTMLElement).append(...settingsOf(report));
  showKeyFigures(report);
  showHistory(report);
  showEvaluations(report);
  showSources(report);
  showProvenance(report);
  const replays: Replays = new Replays(report, (recording) => curve.select(recording));
  const curve = showCharts(report, (recording) => {
    replays.show(recording);
    if (!prefersReducedMotion()) replays.viewer?.play();
  });
  replays.open();
  document.documentElement.dataset["ready"] = "true";
}

main();
