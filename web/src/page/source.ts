// The text of a task.

import { commentStart } from "../data/task_source.ts";
import { element } from "./dom.ts";

/** A text, line by line, with numbers; comments stand back. A child for each line. */
export function sourceCode(text: string): HTMLElement {
  const code = element("code");
  for (const line of text.replace(/\n$/, "").split("\n")) {
    const comment = commentStart(line);
    const row = element("span", { class: "line" }, line.slice(0, comment));
    row.append(element("span", { class: "comment" }, line.slice(comment)), "\n");
    code.append(row);
  }
  return code;
}
