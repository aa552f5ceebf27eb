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

import { byId } from "../page/dom.ts";
import { LivePage, readRecord, type TrainerEvent } from "./live_page.ts";
import { showNotice } from "./notice.ts";
import { addressOf, LastingSocket } from "./trainer.ts";

const kBetweenTries = 1000; // [ms]

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
      window.setTimeout(() => void begin(), kBetweenTries);
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
