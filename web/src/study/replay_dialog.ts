// The replay of one recording, above the page, and of another beside it.

import type { Scenery } from "../data/report_data.ts";
import { byId, element, hasWebGl, prefersReducedMotion } from "../page/dom.ts";
import type { Other } from "../replay/companion.ts";
import type { Replay } from "../replay/motion.ts";
import { Viewer } from "../replay/viewer.ts";

export class ReplayDialog {
  private readonly dialog = byId("replay", HTMLDialogElement);
  private viewer: Viewer | undefined;
  private readonly other = byId("other", HTMLSelectElement);
  private scenery: Scenery | undefined;

  /** `others`: what can be shown beside a recording, all that there are. */
  constructor(private readonly others: Other[]) {
    this.other.append(element("option", { value: "" }, "nothing"));
    others.forEach(({ title }, i) => {
      this.other.append(element("option", { value: String(i) }, title));
    });
    byId("other-label", HTMLElement).hidden = others.length < 2;
    this.other.addEventListener("change", () => this.showOther());
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
    this.viewer.show(recording, 0, title);
    this.other.value = "";
    this.showOther();
    if (!prefersReducedMotion()) this.viewer.play();
  }

  private showOther(): void {
    const other = this.other.value === "" ? undefined : this.others[Number(this.other.value)];
    this.dialog.classList.toggle("comparing", other !== undefined);
    this.viewer?.showBeside(other);
  }
}
