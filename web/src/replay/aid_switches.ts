// What may be drawn beside the robot, as switches that are its legend too, and the link whose joints
// are shown.

import type { BodyLink, ToldGoal } from "../data/report_data.ts";
import { byId, element } from "../page/dom.ts";
import { kFirstAids, type AidSettings } from "./aids.ts";
import { jointsOf } from "./joints.ts";
import type { Stage } from "./stage.ts";
import { placesIn, velocitiesIn } from "./told.ts";

/** What is known of what is shown. */
export interface Known {
  body: BodyLink[];
  hasContacts: boolean;
  goals: ToldGoal[];
}

const kStillPointer = 4; // a click is no drag of the camera [px]

export class AidSwitches {
  private readonly inputs: HTMLInputElement[];
  private readonly select = byId("picked", HTMLSelectElement);
  private readonly stages: Stage[] = [];
  private readonly listeners: ((link: number | undefined) => void)[] = [];
  private body: BodyLink[] = [];
  private settings = kFirstAids;

  /** `onChange` is called where a stage has to be drawn anew. */
  constructor(private readonly onChange: () => void) {
    this.inputs = [...byId("aids", HTMLElement).querySelectorAll<HTMLInputElement>("[data-aid]")];
    for (const input of this.inputs) input.addEventListener("change", () => this.apply());
    this.select.addEventListener("change", () => this.pick(this.picked));
  }

  /** The stage follows the switches from now on, and links are picked by a click in it. */
  connect(stage: Stage): void {
    this.stages.push(stage);
    stage.setAids(this.settings);
    stage.pick(this.picked);
    let from = { x: 0, y: 0 };
    stage.canvas.addEventListener("pointerdown", ({ clientX: x, clientY: y }) => (from = { x, y }));
    stage.canvas.addEventListener("click", ({ clientX, clientY }) => {
      if (Math.hypot(clientX - from.x, clientY - from.y) > kStillPointer) return;
      const { left, top, width, height } = stage.canvas.getBoundingClientRect();
      const x = (2 * (clientX - left)) / width - 1;
      this.pick(stage.linkAt(x, 1 - (2 * (clientY - top)) / height));
    });
  }

  /** Offers what there is to see. */
  offer({ body, hasContacts, goals }: Known): void {
    const links = body.filter((part) => !part.thing);
    const isThere: Record<keyof AidSettings, boolean> = {
      trail: true,
      lit: hasContacts,
      points: hasContacts,
      mass: links.length > 0 && links.every(({ mass }) => mass !== undefined),
      goals: placesIn(goals).length + velocitiesIn(goals).length > 0,
    };
    for (const input of this.inputs) {
      const label = input.closest("label") as HTMLElement;
      label.hidden = !isThere[input.dataset["aid"] as keyof AidSettings];
    }
    if (body !== this.body) this.offerLinks(body);
  }

  /** Index of the link whose joints are shown. */
  get picked(): number | undefined {
    return this.select.value === "" ? undefined : Number(this.select.value);
  }

  onPick(listener: (link: number | undefined) => void): void {
    this.listeners.push(listener);
  }

  private offerLinks(body: BodyLink[]): void {
    this.body = body;
    const options = body.flatMap(({ name }, link) =>
      jointsOf(body, link).length > 0
        ? [element("option", { value: String(link) }, name.replaceAll("_", " "))]
        : [],
    );
    this.select.replaceChildren(element("option", { value: "" }, "a link: click it"), ...options);
    (this.select.closest("label") as HTMLElement).hidden = options.length === 0;
    this.pick(undefined);
  }

  private pick(link: number | undefined): void {
    this.select.value = link === undefined ? "" : String(link);
    if (this.select.selectedIndex < 0) this.select.value = ""; // it has no joint
    for (const stage of this.stages) stage.pick(this.picked);
    for (const listener of this.listeners) listener(this.picked);
    this.onChange();
  }

  private apply(): void {
    const settings = { ...kFirstAids };
    for (const { dataset, checked } of this.inputs) {
      settings[dataset["aid"] as keyof AidSettings] = checked;
    }
    this.settings = settings;
    for (const stage of this.stages) stage.setAids(settings);
    this.onChange();
  }
}
