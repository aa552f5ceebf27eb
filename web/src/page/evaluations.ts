// What the run had learned, acting without learning: `trainer evaluate`.

import { interval, mean } from "../data/estimate.ts";
import type { Evaluation, Report } from "../data/report_data.ts";
import { formatCount, formatNumber } from "../data/words.ts";
import { byId, element } from "./dom.ts";
import { remainsBar, wholePercent } from "./remains.ts";
import { row, table } from "./table.ts";

const kHeads = ["Profile", "", "Remains", "Return", "95 %", "Learned", "After episode", "Ended"];

const endsInWords = (ends: Record<string, number>): string =>
  Object.entries(ends)
    .map(([kind, count]) => `${formatCount(count)} ${kind}`)
    .join(", ");

function evaluationRow(evaluation: Evaluation, learnedIn: string | undefined): HTMLElement {
  const { profile, share, ends } = evaluation;
  return row([
    profile === learnedIn ? `${profile}, its own` : profile,
    remainsBar(share),
    wholePercent(share),
    mean(evaluation.return),
    interval(evaluation.return) || "–",
    formatNumber(evaluation.learned_return ?? undefined),
    formatCount(evaluation.checkpoint_episode),
    endsInWords(ends),
  ]);
}

/** Shows nothing of a run that was not evaluated. */
export function showEvaluations({ evaluations, run }: Report): void {
  byId("evaluations-section", HTMLElement).hidden = evaluations.length === 0;
  if (evaluations.length === 0) return;
  const words =
    "The policy after the given episode, acting without learning: its mean return, and the share " +
    "that remains of the mean return of the last episodes in which it learned.";
  const rows = evaluations.map((evaluation) => evaluationRow(evaluation, run["profile"]));
  const host = table(kHeads, rows);
  host.classList.add("evaluations-table");
  byId("evaluations", HTMLElement).append(element("p", { class: "note" }, words), host);
}
