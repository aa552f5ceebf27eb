// The page of a folder of runs: which there are, how far they are, and what they have learned.

import "uplot/dist/uPlot.min.css";
import "../style/theme.css";
import "../style/page.css";
import "../style/charts.css";
import "../style/live.css";
import "../style/runs.css";

import { seriesColor } from "../charts/series.ts";
import { formatCount } from "../data/words.ts";
import { showNotice } from "../live/notice.ts";
import { ask } from "../live/trainer.ts";
import { byId, onThemeChange } from "../page/dom.ts";
import { Comparison } from "./comparison.ts";
import { isTrained, type Run, type RunListing } from "./run.ts";
import { RunRows } from "./run_rows.ts";
import { StartForm, type PageData } from "./start_form.ts";

const kBetweenLooks = 1000; // [ms]
const kFirstChosen = 15; // as many runs are compared before the user chooses

class RunsPage {
  private readonly rows = new RunRows(byId("runs", HTMLElement), {
    onChoose: () => {
      this.hasChosen = true;
      void this.compare();
    },
    onCommand: (command, run) => void this.attempt(() => ask(command, { run })),
  });
  private readonly comparison = new Comparison();
  private runs: Run[] = [];
  private hasChosen = false;

  constructor() {
    const data = JSON.parse(byId("page-data", HTMLElement).textContent ?? "") as PageData;
    new StartForm(data, () => void this.look());
    byId("choose-all", HTMLButtonElement).addEventListener("click", () => this.choose(this.runs));
    byId("choose-none", HTMLButtonElement).addEventListener("click", () => this.choose([]));
    onThemeChange(() => this.rows.redraw());
    void this.follow();
  }

  private async follow(): Promise<void> {
    for (;;) {
      if (!document.hidden) await this.look();
      document.documentElement.dataset["ready"] = "true";
      await new Promise((done) => window.setTimeout(done, kBetweenLooks));
    }
  }

  private async look(): Promise<void> {
    try {
      const { folder, runs } = await ask<RunListing>("runs");
      this.showListing(folder, runs);
    } catch {
      byId("folder-state", HTMLElement).textContent = "the server does not answer";
      byId("folder-state", HTMLElement).dataset["state"] = "lost";
      return;
    }
    await this.compare();
  }

  private showListing(folder: string, runs: Run[]): void {
    this.runs = runs;
    this.rows.show(runs);
    if (!this.hasChosen) {
      const made = runs.filter(({ episodes }) => episodes > 0);
      this.rows.choose(made.slice(0, kFirstChosen).map(({ name }) => name));
    }
    const state = byId("folder-state", HTMLElement);
    const count = runs.filter(isTrained).length;
    state.textContent = count > 0 ? `${formatCount(count)} in training` : "nothing is being trained";
    state.dataset["state"] = count > 0 ? "running" : "finished";
    byId("folder", HTMLElement).textContent = folder;
    byId("no-runs", HTMLElement).hidden = runs.length > 0;
  }

  private choose(runs: Run[]): void {
    this.hasChosen = true;
    this.rows.choose(runs.map(({ name }) => name));
    void this.compare();
  }

  private async compare(): Promise<void> {
    const names = this.rows.chosen;
    const chosen = this.runs.filter(({ name, episodes }) => episodes > 0 && names.includes(name));
    this.rows.color(new Map(chosen.map(({ name }, i) => [name, seriesColor(i)])));
    await this.attempt(() => this.comparison.show(chosen));
  }

  private async attempt(action: () => Promise<unknown>): Promise<void> {
    try {
      await action();
      showNotice("");
    } catch (error) {
      showNotice((error as Error).message);
    }
  }
}

new RunsPage();
