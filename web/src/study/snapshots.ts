// Snapshot strips of many recordings, drawn when they come into view.

import type { BodyLink } from "../data/report_data.ts";
import { formatTime } from "../data/words.ts";
import { element, hasWebGl, onThemeChange } from "../page/dom.ts";
import { durationOf, snapshotTimes, type Replay } from "../replay/motion.ts";
import { Stage } from "../replay/stage.ts";

const kSnapshots = 8;
const kPixels = 260; // of each picture

export class Snapshots {
  private readonly draw = new Map<Element, () => void>();
  private readonly drawn = new Set<Element>();
  private readonly observer: IntersectionObserver;
  private stage: Stage | undefined;
  private body: BodyLink[] = [];

  constructor() {
    this.observer = new IntersectionObserver((entries) => this.onView(entries), {
      rootMargin: "300px",
    });
    window.addEventListener("beforeprint", () => this.draw.forEach((draw) => draw()));
    onThemeChange(() => this.drawn.forEach((strip) => this.draw.get(strip)?.()));
  }

  /** A strip of `recording`; empty where nothing can be drawn. */
  strip(recording: Replay, body: BodyLink[]): HTMLElement {
    const strip = element("ol", { class: "strip" });
    if (!hasWebGl()) return strip;
    const duration = durationOf(recording);
    const times = snapshotTimes(duration, 0, duration, kSnapshots);
    const canvases = times.map((time) => {
      const canvas = element("canvas", { width: `${kPixels}`, height: `${kPixels}` });
      const caption = element("span", { class: "caption" }, `${formatTime(time, duration)} s`);
      strip.append(element("li", {}, canvas, caption));
      return canvas;
    });
    this.draw.set(strip, () => {
      const stage = this.stageFor(body);
      stage.show(recording);
      stage.drawSnapshots(times, canvases);
    });
    this.observer.observe(strip);
    return strip;
  }

  private onView(entries: IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting || this.drawn.has(target)) continue;
      this.drawn.add(target);
      this.draw.get(target)?.();
    }
  }

  private stageFor(body: BodyLink[]): Stage {
    this.stage ??= new Stage(body, () => undefined);
    if (this.body !== body) this.stage.setBody(body);
    this.body = body;
    return this.stage;
  }
}
