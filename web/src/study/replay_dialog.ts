// The replay of one recording, above the page.

import type { Scenery } from "../data/report_data.ts";
import { byId, hasWebGl, prefersReducedMotion } from "../page/dom.ts";
import type { Replay } from "../replay/motion.ts";
import { Viewer } from "../replay/viewer.ts";

export class ReplayDialog {
  private readonly dialog = byId("replay", HTMLDialogElement);
  private viewer: Viewer | undefined;
  private scenery: Scenery | undefined;

  constructor() {
    byId("close", HTMLButtonElement).addEventListener("click", () => this.dialog.close());
    this.dialog.addEventListener("close", () => this.viewer?.pause());
    this.dialog.addEventListener("click", (event) => {
      if (event.target === this.dialog) this.dialog.close(); // beside it
    });
  }

  show(recording: Replay, scenery: Scenery, title: string): void {
    byId("replay-heading", HTMLElement).textContent = title;
    this.dialog.showModal();
    if (!hasWebGl()) {
      byId("stage-message", HTMLElement).textContent =
        "This browser offers no WebGL, so the replay cannot be drawn here.";
      return;
    }
    this.viewer ??= new Viewer(scenery);
    if (this.scenery !== scenery) this.viewer.setScenery(scenery);
    this.scenery = scenery;
    this.viewer.show(recording);
    if (!prefersReducedMotion()) this.viewer.play();
  }
}
