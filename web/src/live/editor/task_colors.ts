// The colors of a task's text, from the grammar that editors color it by (editors/vscode/syntaxes).

import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { tags, type Tag } from "@lezer/highlight";

import grammar from "../../../syntaxes/task.tmLanguage.json";

interface Rule {
  name?: string;
  match?: string;
  begin?: string;
  end?: string;
  captures?: Record<string, { name: string }>;
  include?: string;
  patterns?: Rule[];
}

/** The first that a scope's name begins with gives its color. */
const kScopes: [string, string, Tag][] = [
  ["comment", "comment", tags.comment],
  ["punctuation.definition.comment", "comment", tags.comment],
  ["string", "string", tags.string],
  ["constant.character", "escape", tags.escape],
  ["constant.numeric", "number", tags.number],
  ["keyword.other.unit", "unit", tags.unit],
  ["keyword.operator.word", "keyword", tags.keyword],
  ["keyword.operator", "operator", tags.operator],
  ["keyword", "keyword", tags.keyword],
  ["storage", "keyword", tags.keyword],
  ["constant.language", "atom", tags.atom],
  ["constant", "atom", tags.atom],
  ["entity.name.class", "definition", tags.definition(tags.name)],
  ["entity.name", "function", tags.function(tags.name)],
  ["support.function", "function", tags.function(tags.name)],
  ["support.type", "type", tags.typeName],
  ["support.class", "type", tags.typeName],
  ["support.variable", "sensor", tags.propertyName],
  ["variable.language", "sensor", tags.propertyName],
];

interface Pattern {
  expression: RegExp;
  name: string | undefined;
  captures: [number, string][];
}

const colorOf = (scope: string): string | null =>
  kScopes.find(([prefix]) => scope.startsWith(prefix))?.[1] ?? null;

/** All patterns in the order in which they are tried. A stretch from begin to end is one line's. */
function patternsOf(rules: Rule[]): Pattern[] {
  return rules.flatMap((rule) => {
    if (rule.include) {
      const repository = grammar.repository as Record<string, Rule>;
      const included = repository[rule.include.slice(1)] as Rule;
      return patternsOf(included.match || included.begin ? [included] : (included.patterns ?? []));
    }
    const text = rule.match ?? `${rule.begin}(?:\\\\.|(?!${rule.end}).)*(?:${rule.end})`;
    const captures = Object.entries(rule.captures ?? {}).map(
      ([index, { name }]): [number, string] => [Number(index), name],
    );
    return [{ expression: new RegExp(text, "yd"), name: rule.name, captures }];
  });
}

const kPatterns = patternsOf(grammar.patterns as Rule[]);

interface Piece {
  end: number;
  color: string | null;
}

/** The colors of what a pattern has matched, piece by piece. */
function piecesOf({ name, captures }: Pattern, match: RegExpExecArray): Piece[] {
  const whole = name ? colorOf(name) : null;
  const pieces: Piece[] = [];
  for (const [index, scope] of captures) {
    const place = match.indices?.[index];
    if (!place) continue;
    pieces.push({ end: place[0], color: whole }, { end: place[1], color: colorOf(scope) });
  }
  pieces.push({ end: match.index + match[0].length, color: whole });
  return pieces;
}

function match(line: string, at: number): Piece[] {
  for (const pattern of kPatterns) {
    pattern.expression.lastIndex = at;
    const found = pattern.expression.exec(line);
    if (found && found[0].length > 0) return piecesOf(pattern, found);
  }
  return [];
}

const language = StreamLanguage.define<{ pieces: Piece[] }>({
  name: "task",
  startState: () => ({ pieces: [] }),
  copyState: ({ pieces }) => ({ pieces: [...pieces] }),
  token(stream, state) {
    if (stream.sol()) state.pieces = [];
    if (state.pieces.length === 0) state.pieces = match(stream.string, stream.pos);
    while (state.pieces.length > 0) {
      const { end, color } = state.pieces.shift() as Piece;
      if (end <= stream.pos) continue;
      stream.pos = end;
      return color;
    }
    stream.next();
    return null;
  },
  languageData: { commentTokens: { line: "//" }, closeBrackets: { brackets: ["(", "[", "{", '"'] } },
  tokenTable: Object.fromEntries(kScopes.map(([, color, tag]) => [color, tag])),
});

const style = HighlightStyle.define(
  [...new Map(kScopes.map(([, color, tag]) => [color, tag]))].map(([color, tag]) => ({
    tag,
    class: `task-${color}`,
  })),
);

export const taskColors = (): Extension => [language, syntaxHighlighting(style)];
