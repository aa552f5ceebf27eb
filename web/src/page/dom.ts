// Small helpers for building the page. Text always goes in as text, never as markup.

type Child = Node | string;
type Attributes = Record<string, string>;

/** A new element; `class`, `title`, … come from `attributes`. */
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** A number that changes while one looks: it is not read aloud each time. */
export function readout(attributes: Attributes = {}): HTMLOutputElement {
  return element("output", { "aria-live": "off", ...attributes });
}

/** The element of the template with this id and type. */
export function byId<Type extends HTMLElement>(id: string, type: new () => Type): Type {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`the page has no ${type.name} called ${id}`);
  return found;
}

/** Calls `listener` whenever light changes to dark or back. */
export function onThemeChange(listener: () => void): void {
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", listener);
}

/** The value of a color of the style sheet in the present theme, e.g. "--ink". */
export const themeColor = (name: string): string =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export const prefersReducedMotion = (): boolean =>
  window.matchMedia("(prefers-reduced-motion: reduce)").matches;

export const hasWebGl = (): boolean =>
  document.createElement("canvas").getContext("webgl2") !== null;

/** Gives up the focus after a click by mouse or finger: the next space bar is for the replay. */
export function leaveAfterClick(button: HTMLElement, event: MouseEvent): void {
  const isByKey = event.detail === 0;
  if (!isByKey) button.blur();
}
