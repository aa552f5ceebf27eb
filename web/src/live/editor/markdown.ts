// The little Markdown that the language server writes: paragraphs, code, emphasis. Whatever is in
// it becomes text, never markup of the page.

import { element } from "../../page/dom.ts";

function inline(text: string): (Node | string)[] {
  return text.split(/(`[^`]+`|\*\*[^*]+\*\*)/).map((part) => {
    if (part.length > 2 && part.startsWith("`")) return element("code", {}, part.slice(1, -1));
    if (part.startsWith("**") && part.length > 4) return element("strong", {}, part.slice(2, -2));
    return part.replace(/\[([^\]]+)\]\([^)]*\)/g, "$1");
  });
}

export function markdownToDom(markdown: string): HTMLElement {
  const host = element("div", { class: "markdown" });
  const parts = markdown.split(/^```\w*\n([\s\S]*?)\n?^```$/m);
  parts.forEach((part, i) => {
    if (i % 2 === 1) {
      host.append(element("pre", {}, part));
      return;
    }
    for (const paragraph of part.split(/\n{2,}/)) {
      if (paragraph.trim() !== "") host.append(element("p", {}, ...inline(paragraph.trim())));
    }
  });
  return host;
}
