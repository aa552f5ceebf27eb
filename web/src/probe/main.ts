// Builds the page of a probe from the data that it carries.

import "../style/theme.css";
import "../style/page.css";
import "../style/replay.css";
import "../style/study.css";
import "../style/probe.css";

import { docOfTask } from "../data/task_source.ts";
import { formatCount, formatDate, formatDuration } from "../data/words.ts";
import { byId, element } from "../page/dom.ts";
import type { Other } from "../replay/companion.ts";
import { ReplayDialog } from "../study/replay_dialog.ts";
import { decodeProbe, type Find, type Probe } from "./data.ts";
import { findCard } from "./find_card.ts";

function showMasthead(probe: Probe): void {
  const name = probe.task.replaceAll("_", " ");
  byId("task-name", HTMLElement).textContent = `What ${name} pays for`;
  byId("task-doc", HTMLElement).textContent = docOfTask(probe.source);
  byId("agent-words", HTMLElement).textContent = `${probe.robot} · profile ${probe.profile}`;
  const facts = [
    ["Searches", formatCount(probe.searches)],
    ["Episodes", formatCount(probe.episodes)],
    ["CPU time", formatDuration(60 * probe.cpu_minutes)],
    ["Page generated", formatDate(probe.madeAt)],
  ] as const;
  for (const [fact, value] of facts) {
    byId("probe-facts", HTMLElement).append(
      element("div", {}, element("dt", {}, fact), element("dd", {}, value)),
    );
  }
}

const sentences = ({ finds, left_out, diverged, notes }: Probe): string[] => [
  finds.length === 0 ? "No search has found anything yet." : "",
  left_out > 0 ? `${formatCount(left_out)} other motions, which are paid less, are left out.` : "",
  diverged > 0 ? `${formatCount(diverged)} of the episodes diverged.` : "",
  ...notes,
];

const titleOf = ({ name, seed, episode }: Find): string =>
  `${name}: seed ${seed}, episode ${episode}`;

function main(): void {
  const probe = decodeProbe(byId("report-data", HTMLElement).textContent ?? "");
  showMasthead(probe);
  const others = probe.finds.map((find): Other => {
    return { title: titleOf(find), replay: find.recording, scenery: probe };
  });
  const dialog = new ReplayDialog(others);
  for (const find of probe.finds) {
    const replay = (): void => dialog.show(find.recording, probe, titleOf(find));
    byId("finds", HTMLElement).append(findCard(find, probe.searches, replay));
  }
  const list = byId("notes", HTMLElement);
  list.append(...sentences(probe).filter(Boolean).map((text) => element("li", {}, text)));
  list.hidden = list.childElementCount === 0;
  requestAnimationFrame(() => (document.documentElement.dataset["ready"] = "true"));
}

main();
