// One experiment: its curves, what came out of its runs, and the groups in which they ended.

import { type Estimate, interval, mean } from "../data/estimate.ts";
import { docOfTask } from "../data/task_source.ts";
import { agentInWords, formatCount, formatNumber, withUnit } from "../data/words.ts";
import { element } from "../page/dom.ts";
import { figure } from "../page/figure.ts";
import { remainsBar, wholePercent } from "../page/remains.ts";
import { settingsOf } from "../page/settings.ts";
import { row, table } from "../page/table.ts";
import { termRow } from "../page/term_row.ts";
import { Curves } from "./curves.ts";
import type { Evaluation, Experiment, Group, StudyRun, Term } from "./data.ts";
import { GroupCards } from "./groups.ts";
import { showPreferences } from "./preferences.ts";
import { colorOf, count, runs } from "./words.ts";

const kStates: Record<string, string> = { interrupted: "stopped" };

const number = (value: number | null): string => formatNumber(value ?? undefined);

export const idOf = (index: number): string => `experiment-${index + 1}`;

function heading(experiment: Experiment): HTMLElement {
  const { name, task, profile, robot } = experiment;
  const words = [agentInWords(experiment.modules), robot, `profile ${profile}`];
  return element(
    "header",
    {},
    element("h2", {}, name),
    element("p", {}, docOfTask(experiment.source) || task.replaceAll("_", " ")),
    element("p", { class: "note" }, words.filter(Boolean).join(" · ")),
    ...settingsOf(experiment),
  );
}

/** The interval, or why there is none. */
const intervalOf = (estimate: Estimate, format?: (value: number | undefined) => string): string =>
  interval(estimate, format) ? `95 %: ${interval(estimate, format)}` : `of ${runs(estimate.count)}`;

function keyFigures(experiment: Experiment): HTMLElement {
  const { final_return, best_return } = experiment;
  const { episodes_to_80_percent: episodes, cpu_minutes_to_80_percent: minutes } = experiment;
  const name = experiment.is_settled ? "Final return" : "Return so far";
  const bests = `mean of the runs’ best ${mean(best_return)}`;
  const list = element("dl", { class: "figures" });
  list.append(
    figure(name, mean(final_return), intervalOf(final_return)),
    figure("Best episode", number(best_return.greatest), bests),
    figure("Episodes to 80 %", mean(episodes, count), intervalOf(episodes, count)),
    figure("CPU minutes to 80 %", mean(minutes), intervalOf(minutes)),
  );
  for (const metric of experiment.metrics) {
    list.append(figure(withUnit(metric), mean(metric.value), intervalOf(metric.value)));
  }
  return list;
}

const termRowOf = ({ value, ...term }: Term): HTMLTableRowElement => termRow(term, mean(value));

/** A profile, what the runs' policies earn there, and a bar for what remains of the learned return. */
function evaluationRow(evaluation: Evaluation, learnedIn: string): HTMLTableRowElement {
  const { profile, return: there, share, median_share } = evaluation;
  return row([
    profile === learnedIn ? `${profile}, its own` : profile,
    remainsBar(share),
    wholePercent(share),
    wholePercent(median_share),
    element("span", { title: `${runs(there.count)}, 95 %: ${interval(there)}` }, mean(there)),
  ]);
}

/** How much of the return is left in other profiles; nothing where no run was evaluated. */
function evaluationTable({ evaluations, profile }: Experiment): HTMLElement[] {
  if (evaluations.length === 0) return [];
  const heads = ["Profile", "", "Remains", "Median", "Return"];
  const host = table(
    heads,
    evaluations.map((evaluation) => evaluationRow(evaluation, profile)),
  );
  host.classList.add("evaluations-table");
  const words =
    "The final policies, acting without learning: the share of the final return that remains, " +
    "for all runs together and for the median run.";
  return [
    element("h3", {}, "In other physics"),
    element("p", { class: "note" }, words),
    host,
  ];
}

function termTable(experiment: Experiment): HTMLElement {
  const rows = experiment.terms.map(termRowOf);
  const heads = ["Term", "", "Share", "Per episode"];
  const host = table(heads, rows);
  host.classList.add("terms-table");
  return host;
}

function runRow(run: StudyRun, experiment: Experiment): HTMLTableRowElement {
  const group = run.group === null ? "" : (experiment.groups[run.group]?.name ?? "");
  const swatch = element("span", { class: "swatch", "aria-hidden": "true" });
  swatch.style.background = `var(${colorOf(run.group)})`;
  return row([
    element("span", {}, swatch, run.name),
    kStates[run.state] ?? run.state,
    `${formatCount(run.episodes)} / ${formatCount(run.episodes_planned)}`,
    number(run.final_return),
    number(run.best_return),
    count(run.episodes_to_80_percent ?? undefined),
    number(run.cpu_minutes_to_80_percent),
    number(run.cpu_minutes),
    ...experiment.metrics.map(({ name }) => formatNumber(run.metrics[name])),
    group,
  ]);
}

function runTable(experiment: Experiment): HTMLElement {
  const heads = [
    ...["Run", "State", "Episodes", "Final return", "Best", "Episodes to 80 %"],
    ...["CPU min to 80 %", "CPU min"],
    ...experiment.metrics.map(withUnit),
    "Group",
  ];
  const rows = experiment.runs.map((run) => runRow(run, experiment));
  const host = table(heads, rows);
  host.classList.add("runs-table");
  return element("details", {}, element("summary", {}, "Runs"), host);
}

/** Where the runs ended, in words. */
function groupWords({ groups, runs: all }: Experiment): string {
  const open = all.filter((run) => run.group === null).length;
  const words = ` ${runs(open)}, not finished or without a recording, in none of them.`;
  if (groups.length === 0) return "No finished run has a recording yet.";
  const number = groups.length === 1 ? "one group" : `${groups.length} groups`;
  return `The finished runs, by their last recorded episodes, fall into ${number}.${open > 0 ? words : ""}`;
}

/** The section of an experiment; `replay` is called for a group whose replay is asked for. */
export function showExperiment(
  experiment: Experiment,
  index: number,
  folder: string,
  replay: (group: Group, title: string) => void,
): HTMLElement {
  const id = { class: "experiment", id: idOf(index) };
  if (experiment.curve.episodes.length === 0) {
    const note = element("p", { class: "note" }, "No run has an episode yet.");
    return element("section", id, heading(experiment), note);
  }
  const chart = element("div", {});
  const section = element(
    "section",
    id,
    heading(experiment),
    keyFigures(experiment),
    element(
      "div",
      { class: "first-row" },
      element("div", {}, element("h3", {}, "Learning curves"), chart),
      element(
        "div",
        {},
        element("h3", {}, "Return by reward term"),
        termTable(experiment),
        ...evaluationTable(experiment),
      ),
    ),
    element("h3", {}, "Where the runs ended"),
    element("p", { class: "note" }, groupWords(experiment)),
  );
  // The chart takes its width from the page.
  requestAnimationFrame(() => {
    const curves = new Curves(experiment, chart);
    const emphasize = (numbers: number[]): void => curves.emphasize(numbers);
    const cards = new GroupCards(experiment, { emphasize, replay });
    section.append(cards.element, ...showPreferences(experiment, folder), runTable(experiment));
  });
  return section;
}
