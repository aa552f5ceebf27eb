// The page of `taskc doc`: sets the formulas that taskc wrote as LaTeX.

import katex from "katex";

import "./document.css";

for (const formula of document.querySelectorAll<HTMLElement>(".math")) {
  katex.render(formula.textContent, formula, {
    displayMode: formula.tagName === "DIV",
    throwOnError: false,
  });
}
document.documentElement.dataset["ready"] = "true";
