// What the trainer refuses, on top of the page.

import { byId } from "../page/dom.ts";

/** "" takes it away. */
export function showNotice(words: string): void {
  const notice = byId("notice", HTMLElement);
  notice.textContent = words;
  notice.hidden = words === "";
}
