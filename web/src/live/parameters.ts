// The parameters of tasks and modules: sliders in their ranges, and what is planned for them.

import { formatCount, formatNumber } from "../data/words.ts";
import { byId, element } from "../page/dom.ts";
import { ask } from "./trainer.ts";

type Value = number | boolean | string | number[];

export interface Parameter {
  name: string;
  value: Value;
  unit: string;
  doc: string;
  minimum?: number;
  maximum?: number;
  choices?: string[];
  live?: boolean; // false: it has no effect after the start
}

interface Schedule {
  name: string;
  from: number;
  to: number;
  first_episode: number;
  episodes: number;
}

export interface TaskModule {
  module: string;
  task: string;
  file: string;
  hash: string;
  role: "active" | "shadow";
  previous: { task: string; hash: string } | null;
  versions: { number: number; task: string; hash: string; file: string }[];
  params: Parameter[];
  goals: { name: string; value: number[]; unit: string; held: boolean; doc: string }[];
  return: number;
  terms: Record<string, number>;
}

/** The reply to `list`. */
export interface Listing {
  tasks: TaskModule[];
  modules: { name: string; started: boolean }[];
  schedules: Schedule[];
}

const kSteps = 200; // of a slider

/** The control of one parameter. */
class Control {
  readonly row: HTMLElement;
  private readonly inputs: (HTMLInputElement | HTMLSelectElement)[] = [];
  private readonly plan = element("span", { class: "plan" });
  private readonly refusal = element("p", { class: "refusal", role: "alert" });
  private value: Value;

  constructor(
    private readonly module: string,
    private readonly parameter: Parameter,
    private readonly onSet: () => void,
  ) {
    this.value = parameter.value;
    const { name, unit, doc } = parameter;
    const id = `parameter-${module}-${name}`;
    const label = element("label", { for: id }, name);
    if (unit) label.append(" ", element("span", { class: "unit" }, unit));
    this.makeInputs(id);
    this.row = element(
      "div",
      { class: "parameter", "data-parameter": this.fullName },
      label,
      element("div", { class: "inputs" }, ...this.inputs),
      element("p", { class: "note" }, doc, this.plan),
      this.refusal,
    );
    this.showValue();
  }

  get fullName(): string {
    return `${this.module}.${this.parameter.name}`;
  }

  /** What the trainer says now; what a user is about to change stays. */
  refresh(value: Value, schedule: Schedule | undefined): void {
    this.plan.textContent = schedule ? scheduleInWords(schedule) : "";
    if (this.inputs.includes(document.activeElement as HTMLInputElement)) return;
    this.value = value;
    this.showValue();
  }

  private makeInputs(id: string): void {
    const { value, choices, minimum, maximum, live } = this.parameter;
    if (typeof value === "boolean") {
      this.addInput(element("input", { type: "checkbox", id }));
    } else if (choices) {
      const options = choices.map((choice) => element("option", {}, choice));
      this.addInput(element("select", { id }, ...options));
    } else if (typeof value === "number") {
      if (minimum !== undefined && maximum !== undefined) this.addSlider(minimum, maximum);
      this.addInput(element("input", { type: "number", step: "any", id }));
    } else {
      this.addInput(element("input", { type: "text", id }));
    }
    for (const input of this.inputs) input.disabled = live === false;
  }

  private addSlider(minimum: number, maximum: number): void {
    const step = Number.isInteger(this.value) && this.isWhole ? 1 : (maximum - minimum) / kSteps;
    const slider = element("input", {
      type: "range",
      min: String(minimum),
      max: String(maximum),
      step: String(step),
      "aria-label": this.fullName,
      title: `${formatNumber(minimum)} … ${formatNumber(maximum)} ${this.parameter.unit}`.trim(),
    });
    slider.addEventListener("input", () => {
      const number = this.inputs.find((input) => input.type === "number");
      if (number) number.value = formatInput(slider.valueAsNumber);
      this.markDone(slider);
    });
    this.addInput(slider);
  }

  /** Numbers of JSON do not say whether they are integers: a range of few whole ones does. */
  private get isWhole(): boolean {
    const { minimum = NaN, maximum = NaN } = this.parameter;
    return Number.isInteger(minimum) && Number.isInteger(maximum) && maximum - minimum > 20;
  }

  private addInput(input: HTMLInputElement | HTMLSelectElement): void {
    this.inputs.push(input);
    input.addEventListener("change", () => void this.set(this.valueOf(input)));
  }

  private valueOf(input: HTMLInputElement | HTMLSelectElement): Value {
    if (input instanceof HTMLSelectElement) return input.value;
    if (input.type === "checkbox") return input.checked;
    if (input.type !== "text") return input.type === "range" ? Number(formatInput(input.valueAsNumber)) : input.valueAsNumber;
    if (!Array.isArray(this.value)) return input.value;
    return input.value.split(/[\s,]+/).filter(Boolean).map(Number);
  }

  private async set(value: Value): Promise<void> {
    this.refusal.textContent = "";
    try {
      const reply = await ask<{ value: Value }>("set", { name: this.fullName, value });
      this.value = reply.value;
      this.onSet();
    } catch (error) {
      this.refusal.textContent = (error as Error).message;
    }
    this.showValue();
  }

  private showValue(): void {
    const { value } = this;
    for (const input of this.inputs) {
      if (input instanceof HTMLSelectElement) input.value = String(value);
      else if (typeof value === "boolean") input.checked = value;
      else if (typeof value === "number") input.value = formatInput(value);
      else input.value = Array.isArray(value) ? value.join(" ") : value;
      if (input instanceof HTMLInputElement && input.type === "range") this.markDone(input);
    }
  }

  private markDone(slider: HTMLInputElement): void {
    const [low, high] = [Number(slider.min), Number(slider.max)];
    const share = high > low ? (slider.valueAsNumber - low) / (high - low) : 0;
    slider.style.setProperty("--done", `${100 * share}%`);
  }
}

/** Without the digits that adding up steps leaves behind. */
const formatInput = (value: number): string => String(Number(value.toPrecision(6)));

const scheduleInWords = ({ from, to, first_episode: first, episodes }: Schedule): string =>
  `schedule: ${formatNumber(from)} to ${formatNumber(to)} over the episodes ` +
  `${formatCount(first)} to ${formatCount(first + episodes - 1)}`;

export class Parameters {
  private readonly host = byId("parameters", HTMLElement);
  private controls = new Map<string, Control>();
  private shown = ""; // which parameters there are

  constructor(private readonly onSet: () => void) {}

  /** Shows what there is: of the tasks from the listing, of other modules as the trainer says. */
  async refresh(listing: Listing): Promise<void> {
    const modules = await this.modulesOf(listing);
    const all = modules.map(({ name, parameters }) => [name, parameters.map((each) => each.name)]);
    const names = JSON.stringify(all);
    if (names !== this.shown) {
      this.shown = names;
      this.controls.clear();
      this.host.replaceChildren(...modules.map((module) => this.makeModule(module)));
    }
    for (const { name, parameters } of modules) {
      for (const parameter of parameters) {
        const fullName = `${name}.${parameter.name}`;
        const schedule = listing.schedules.find((each) => each.name === fullName);
        this.controls.get(fullName)?.refresh(parameter.value, schedule);
      }
    }
  }

  private async modulesOf(listing: Listing): Promise<ModuleParameters[]> {
    const tasks = listing.tasks.map(({ module, task, role, params }) => ({
      name: module,
      words: `${role === "active" ? "task" : "shadow"} ${task}`,
      isOpen: true,
      parameters: params,
    }));
    const others = listing.modules.filter(({ name }) => !tasks.some((task) => task.name === name));
    const parameters = await Promise.all(
      others.map(async ({ name }) => ({
        name,
        words: "",
        isOpen: false,
        parameters: await ask<Parameter[]>(`get?name=${encodeURIComponent(name)}`),
      })),
    );
    return [...tasks, ...parameters].filter(({ parameters }) => parameters.length > 0);
  }

  private makeModule({ name, words, isOpen, parameters }: ModuleParameters): HTMLElement {
    const rows = parameters.map((parameter) => {
      const control = new Control(name, parameter, this.onSet);
      this.controls.set(control.fullName, control);
      return control.row;
    });
    const note = element("span", { class: "note" }, words || count(parameters.length));
    return element(
      "details",
      isOpen ? { open: "" } : {},
      element("summary", {}, `${name} `, note),
      element("div", { class: "parameter-grid" }, ...rows),
    );
  }
}

interface ModuleParameters {
  name: string;
  words: string;
  isOpen: boolean;
  parameters: Parameter[];
}

const count = (parameters: number): string =>
  `${parameters} parameter${parameters === 1 ? "" : "s"}`;
