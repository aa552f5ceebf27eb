// The tasks of the run: which one pays, which are evaluated beside it, and the text of the one that
// is being edited.

import type { Task } from "../data/report_data.ts";
import { lastValues } from "../data/statistics.ts";
import { formatNumber } from "../data/words.ts";
import { byId, element, readout } from "../page/dom.ts";
import { TaskEditor } from "./editor/task_editor.ts";
import { TaskPageView } from "./editor/task_page.ts";
import type { GrowingRecord } from "./growing_record.ts";
import type { History } from "./history.ts";
import type { Listing, TaskModule } from "./parameters.ts";
import { ask } from "./trainer.ts";
import type { Layout } from "./view_frames.ts";
import { WhatIf } from "./what_if.ts";

const kMeanOf = 20; // episodes
const kNames = ["edited", "edited_2"]; // of the module that an edited text is loaded as

interface Exchange {
  module: string;
  takes_effect: string;
  messages?: string;
}

export interface PageData {
  nonce: string;
  working_folder: string;
}

export class TasksPanel {
  private readonly cards = byId("task-cards", HTMLElement);
  private readonly words = byId("editor-words", HTMLElement);
  private readonly messages = byId("editor-messages", HTMLElement);
  private readonly tryButton = byId("editor-try", HTMLButtonElement);
  private readonly revert = byId("editor-revert", HTMLButtonElement);
  private editor: TaskEditor | undefined;
  private readonly equations = new TaskPageView(
    byId("editor-page", HTMLElement),
    async (known) => (await this.editor?.lets(known)) ?? null,
  );
  private readonly whatIf = new WhatIf(() => ({ file: this.taskFile, text: this.editor?.text ?? "" }));
  private file = "";
  private listing: Listing | undefined;
  private layout: Layout | undefined;
  private returns: { module: string; output: HTMLElement }[] = [];

  constructor(
    private readonly record: GrowingRecord,
    private readonly page: PageData,
    private readonly textOf: (hash: string) => Task | undefined,
    private readonly attempt: (action: () => Promise<unknown>) => Promise<void>,
    private readonly onChange: () => void,
  ) {
    byId("editor-open", HTMLButtonElement).addEventListener("click", () => this.open());
    this.tryButton.addEventListener("click", () => void this.tryIt());
    this.revert.addEventListener("click", () => this.fill());
    byId("editor-format", HTMLButtonElement).addEventListener("click", () => void this.format());
    byId("editor-download", HTMLButtonElement).addEventListener("click", () => this.download());
  }

  show(listing: Listing): void {
    this.listing = listing;
    this.returns = [];
    this.cards.replaceChildren(...listing.tasks.map((task) => this.makeCard(task)));
    this.refreshReturns();
    this.renewNumbers();
  }

  /** The frames are those of another task. */
  showLayout(layout: Layout): void {
    this.layout = layout;
    this.renewNumbers();
  }

  /** What the equations are worth at the moment that is shown. */
  showMoment({ last }: History): void {
    if (this.editor && last) this.equations.update(last);
  }

  private renewNumbers(): void {
    const { layout, listing } = this;
    const params = listing?.tasks.find(({ module }) => module === layout?.module)?.params;
    if (layout && params) this.equations.setTask({ layout, params });
  }

  /** The means of what the tasks say of the last episodes. */
  refreshReturns(): void {
    for (const { module, output } of this.returns) {
      const shadow = this.record.curvesOf("shadow").find(({ name }) => name === module);
      const values = module === this.active?.module ? this.record.returns : (shadow?.values ?? []);
      output.textContent = formatNumber(lastValues(values, this.record.rowsOf(kMeanOf)).mean);
    }
  }

  private makeCard(task: TaskModule): HTMLElement {
    const isActive = task.role === "active";
    const output = readout();
    this.returns.push({ module: task.module, output });
    const button = (words: string, command: string): HTMLElement => {
      const made = element("button", { type: "button", class: "button" }, words);
      made.addEventListener("click", () => void this.do(command, task.module));
      return made;
    };
    const buttons = isActive ? [] : [button("Promote", "promote"), button("Unload", "unload")];
    if (task.previous) buttons.push(button("Roll back", "rollback"));
    return element(
      "article",
      { class: "task-card", "data-module": task.module, "data-role": task.role },
      element("h3", {}, task.module, element("span", { class: "role" }, task.role)),
      element("p", { class: "note" }, `${task.task}, version ${task.hash.slice(0, 8)}`),
      element("p", {}, `mean return of the last ${kMeanOf} episodes `, output),
      element("div", { class: "live-actions" }, ...buttons),
    );
  }

  private do(command: string, module: string): Promise<void> {
    return this.attempt(async () => {
      const { takes_effect: effect } = await ask<Exchange>(command, { name: module });
      this.say(`${command} ${module}: takes effect ${effect === "now" ? effect : `with ${effect}`}`);
      this.onChange();
    });
  }

  private say(words: string): void {
    this.words.textContent = words;
  }

  private get active(): TaskModule | undefined {
    return this.listing?.tasks.find(({ role }) => role === "active");
  }

  private open(): void {
    byId("editor", HTMLElement).hidden = false;
    byId("editor-open", HTMLButtonElement).hidden = true;
    this.file = this.active?.file ?? "edited.task";
    const path = this.file.startsWith("/") ? this.file : `${this.page.working_folder}/${this.file}`;
    const uri = `file://${path.split("/").map(encodeURIComponent).join("/")}`;
    this.editor = new TaskEditor(byId("editor-text", HTMLElement), uri, this.page.nonce, {
      onSave: () => void this.tryIt(),
      onState: (isEdited, errors) => {
        this.tryButton.disabled = !isEdited || errors > 0;
        this.revert.disabled = !isEdited;
        if (errors > 0) this.say(`${errors} error${errors === 1 ? "" : "s"}`);
        else this.say(isEdited ? "edited" : "as the active task has it");
      },
      onPage: (page) => {
        this.equations.show(page);
        this.whatIf.noteEdit();
      },
    });
    this.fill();
  }

  private fill(): void {
    const text = this.textOf(this.active?.hash ?? "")?.sources[0]?.text;
    if (text !== undefined) this.editor?.put(text);
    this.messages.textContent = "";
  }

  private format(): Promise<void> {
    return this.attempt(async () => this.editor?.format());
  }

  /** Builds the text and evaluates it beside the active task. */
  private async tryIt(): Promise<void> {
    if (!this.editor || this.tryButton.disabled) return;
    this.messages.textContent = "";
    this.say("is being built …");
    const tasks = this.listing?.tasks ?? [];
    const shadow = tasks.find(({ module, role }) => role === "shadow" && kNames.includes(module));
    const name = shadow?.module ?? kNames.find((each) => !tasks.some(({ module }) => module === each));
    const request = { name, file: this.taskFile, text: this.editor.text };
    try {
      const done = await ask<Exchange>(shadow ? "swap" : "load", request);
      const effect = done.takes_effect === "already" ? "is there already" : `from ${done.takes_effect} on`;
      this.say(`shadow ${done.module}: ${effect}`);
      this.messages.textContent = done.messages ?? "";
      this.onChange();
    } catch (error) {
      this.say("refused");
      this.messages.textContent = (error as Error).message;
    }
  }

  /** A run may have begun with a plugin that was built before. */
  private get taskFile(): string {
    return this.file.endsWith(".task") ? this.file : `${this.file}.task`;
  }

  private download(): void {
    const link = element("a", { download: this.taskFile.split("/").at(-1) ?? "edited.task" });
    link.href = URL.createObjectURL(new Blob([this.editor?.text ?? ""], { type: "text/plain" }));
    link.click();
    URL.revokeObjectURL(link.href);
  }
}
