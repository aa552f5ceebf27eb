// Puts style and script into the page's template: assemble.mjs TEMPLATE STYLE SCRIPT OUTPUT. What is
// left to fill in, the title and the content, is taskc's.

import { readFileSync, writeFileSync } from "node:fs";

const [template = "", style = "", script = "", output = ""] = process.argv.slice(2);
const text = (file) => readFileSync(file, "utf8");
// Inside an element, its own end tag would end it.
const inside = (element, content) => content.replaceAll(`</${element}`, `<\\/${element}`);

writeFileSync(
  output,
  text(template)
    .replace("{{style}}", () => inside("style", text(style)))
    .replace("{{script}}", () => inside("script", text(script))),
);
