// The replay of one recording, above the page.

import type { BodyLink } from "../data/report_data.ts";
import { byId, hasWebGl, prefersReducedMotion } from "../page/dom.ts";
import type { Replay } from "../replay/motion.ts";
import { Viewer } from "../replay/viewer.ts";

export class ReplayDialog {
  private readonly dialog = byId("replay", HTMLDialogElement);
  private viewer: Viewer | undefined;
  private body: BodyLink[] = [];

  constructor() {
    byId("close", HTMLButtonElement).addEventListener("click", () => this.dialog.close());
    this.dialog.addEventListener("close", () => this.viewer?.pause());
    this.dialog.addEventListener("click", (event) => {
      if (event.target === this.dialog) this.dialog.close(); // beside it
    });
  }

  show(recording: Replay, body: BodyLink[], title: string): void {
    byId("replay-heading", HTMLElement).textContent = title;
    this.dialog.showModal();
    if (!hasWebGl()) {
      byId("stage-message", HTMLElement).textContent =
        "This browser offers no WebGL, so the replay cannot be drawn here.";
      return;
    }
    this.viewer ??= new Viewer(body);
    if (this.body !== body) this.viewer.setBody(body);
    this.body = body;
    this.viewer.show(recording);
    if (!prefersReducedMotion()) this.viewer.play();
  }
}
