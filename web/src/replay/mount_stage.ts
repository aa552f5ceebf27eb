// A stage in its place on the page.

import type { Scenery } from "../data/report_data.ts";
import { Stage } from "./stage.ts";

/** As large as `host`, behind all else that is in it. `onView` is called when the user moves the
 * camera, `onSight` when the stage comes into sight or goes out of it. */
export function mountStage(
  scenery: Scenery,
  host: HTMLElement,
  onView: () => void,
  onSight: () => void = () => undefined,
): Stage {
  const stage = new Stage(scenery, onView);
  const { canvas } = stage;
  canvas.setAttribute("role", "img");
  canvas.tabIndex = 0;
  canvas.addEventListener("focus", () => stage.setZoomable(true));
  canvas.addEventListener("blur", () => stage.setZoomable(false));
  canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
  canvas.addEventListener("dblclick", () => stage.resetView());
  stage.setZoomable(false);
  host.prepend(canvas);
  new IntersectionObserver((seen) => {
    stage.isInSight = seen.at(-1)?.isIntersecting ?? true;
    onSight();
  }).observe(canvas);
  new ResizeObserver(() => {
    if (host.clientWidth === 0) return; // it is hidden
    stage.setSize(host.clientWidth, host.clientHeight);
    stage.draw();
  }).observe(host);
  return stage;
}
