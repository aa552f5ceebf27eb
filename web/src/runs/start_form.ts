// Asks for what is needed to start runs.

import { ask, type Json } from "../live/trainer.ts";
import { byId, element } from "../page/dom.ts";

/** What the server puts into the page. */
export interface PageData {
  tasks: string[];
  profiles: string[];
}

const kWhole = ["episodes", "seed", "runs"];

export class StartForm {
  private readonly form = byId("start", HTMLFormElement);
  private readonly refusal = byId("start-refusal", HTMLElement);

  constructor(
    data: PageData,
    private readonly onStart: (runs: string[]) => void,
  ) {
    const choices = (id: string, values: string[]): void =>
      byId(id, HTMLElement).append(...values.map((value) => element("option", { value }, value)));
    choices("start-tasks", data.tasks);
    choices("start-profile", data.profiles);
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.submit();
    });
  }

  private async submit(): Promise<void> {
    this.refusal.textContent = "";
    const request: Json = {};
    for (const [name, value] of new FormData(this.form)) {
      const text = String(value).trim();
      if (text !== "") request[name] = kWhole.includes(name) ? Number(text) : text;
    }
    try {
      const { runs } = await ask<{ runs: string[] }>("start", request);
      this.onStart(runs);
    } catch (error) {
      this.refusal.textContent = (error as Error).message;
    }
  }
}
