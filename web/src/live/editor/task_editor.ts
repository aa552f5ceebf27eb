// The text of a task, edited in place with the language server behind it.

import {
  acceptCompletion,
  autocompletion,
  closeBrackets,
  closeBracketsKeymap,
  completionKeymap,
  type Completion,
  type CompletionContext,
  type CompletionResult,
} from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { EditorState, type Text } from "@codemirror/state";
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  hoverTooltip,
  keymap,
  lineNumbers,
  type Tooltip,
} from "@codemirror/view";

import {
  LanguageClient,
  type CompletionItem,
  type LspDiagnostic,
  type Position,
  type Range,
  type TextEdit,
} from "./language_client.ts";
import type { KnownNumbers, LetWorth } from "./lets.ts";
import { markdownToDom } from "./markdown.ts";
import { taskColors } from "./task_colors.ts";
import type { TaskPage } from "./task_page.ts";

const kQuiet = 150; // without typing, before the text is checked [ms]
const kError = 1;
const kTypes: Record<number, string> = {
  3: "function",
  6: "variable",
  10: "property",
  11: "constant",
  14: "keyword",
  20: "enum",
  21: "constant",
  25: "type",
};

const positionOf = (text: Text, offset: number): Position => {
  const line = text.lineAt(offset);
  return { line: line.number - 1, character: offset - line.from };
};

function offsetOf(text: Text, { line, character }: Position): number {
  if (line >= text.lines) return text.length;
  const at = text.line(line + 1);
  return Math.min(at.from + character, at.to);
}

const spanOf = (text: Text, range: Range): { from: number; to: number } => ({
  from: offsetOf(text, range.start),
  to: offsetOf(text, range.end),
});

const changeOf = (text: Text, { range, newText }: TextEdit): { from: number; to: number; insert: string } => ({
  ...spanOf(text, range),
  insert: newText,
});

export interface EditorListeners {
  onSave: () => void;
  /** Whether the text is another than the one that was put in, and how many errors it has. */
  onState: (isEdited: boolean, errors: number) => void;
  /** What the text says, typeset; called whenever it has been checked and has no errors. */
  onPage: (page: TaskPage) => void;
}

export class TaskEditor {
  private readonly view: EditorView;
  private readonly client: LanguageClient;
  private original = "";
  private errors = 0;
  private timer = 0;

  /** `uri`: where the text would be a file, so that what it imports is found. */
  constructor(
    host: HTMLElement,
    uri: string,
    nonce: string,
    private readonly listeners: EditorListeners,
  ) {
    this.view = new EditorView({ parent: host, state: this.makeState("", nonce) });
    this.view.scrollDOM.tabIndex = 0; // long lines are scrolled by the keyboard, too
    this.client = new LanguageClient(
      uri,
      () => this.text,
      (diagnostics) => this.showDiagnostics(diagnostics),
    );
  }

  get text(): string {
    return this.view.state.doc.toString();
  }
  get isEdited(): boolean {
    return this.text !== this.original;
  }

  /** Another text, which counts as not edited. */
  put(text: string): void {
    this.original = text;
    this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: text } });
    this.tell();
  }

  async format(): Promise<void> {
    const edits = (await this.client.format()) ?? [];
    const { doc } = this.view.state;
    this.view.dispatch({ changes: edits.map((edit) => changeOf(doc, edit)) });
  }

  /** What the lets of the text are worth where the numbers are `known`. */
  lets(known: KnownNumbers): Promise<LetWorth[] | null> {
    return this.client.lets(known);
  }

  private makeState(text: string, nonce: string): EditorState {
    return EditorState.create({
      doc: text,
      extensions: [
        EditorView.cspNonce.of(nonce),
        lineNumbers(),
        lintGutter(),
        history(),
        drawSelection(),
        bracketMatching(),
        closeBrackets(),
        highlightActiveLine(),
        highlightActiveLineGutter(),
        autocompletion({ icons: false, override: [(context) => this.complete(context)] }),
        hoverTooltip((view, offset) => this.hover(view, offset)),
        taskColors(),
        EditorView.contentAttributes.of({ "aria-label": "The text of the task" }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) this.noteChange();
        }),
        keymap.of([
          { key: "Mod-s", run: () => this.save(), preventDefault: true },
          { key: "Shift-Alt-f", run: () => (void this.format(), true) },
          { key: "Tab", run: acceptCompletion },
          ...closeBracketsKeymap,
          ...completionKeymap,
          ...lintKeymap,
          ...historyKeymap,
          ...defaultKeymap,
          indentWithTab,
        ]),
      ],
    });
  }

  private save(): boolean {
    this.listeners.onSave();
    return true;
  }

  private noteChange(): void {
    this.tell();
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.flush(), kQuiet);
  }

  /** Lets the language server know the text as it is. */
  private flush(): void {
    if (this.timer === 0) return;
    window.clearTimeout(this.timer);
    this.timer = 0;
    this.client.change();
  }

  private tell(): void {
    this.listeners.onState(this.isEdited, this.errors);
  }

  private showDiagnostics(found: LspDiagnostic[]): void {
    const { doc } = this.view.state;
    const diagnostics = found.map((diagnostic): Diagnostic => {
      const { from, to } = spanOf(doc, diagnostic.range);
      return {
        from,
        to,
        severity: diagnostic.severity === kError ? "error" : "warning",
        source: diagnostic.code,
        message: diagnostic.message,
        actions: (diagnostic.data?.fixes ?? []).map((fix) => ({
          name: fix.title,
          apply: (view) => view.dispatch({ changes: changeOf(view.state.doc, fix) }),
        })),
      };
    });
    this.view.dispatch(setDiagnostics(this.view.state, diagnostics));
    this.errors = diagnostics.filter(({ severity }) => severity === "error").length;
    this.tell();
    if (this.errors === 0) void this.showPage();
  }

  private async showPage(): Promise<void> {
    const page = await this.client.page().catch(() => null);
    if (page) this.listeners.onPage(page);
  }

  private async hover(view: EditorView, offset: number): Promise<Tooltip | null> {
    this.flush();
    const text = view.state.doc;
    const found = await this.client.hover(positionOf(text, offset)).catch(() => null);
    if (!found) return null;
    const { from, to } = found.range ? spanOf(text, found.range) : { from: offset, to: offset };
    return { pos: from, end: to, create: () => ({ dom: markdownToDom(found.contents.value) }) };
  }

  private async complete(context: CompletionContext): Promise<CompletionResult | null> {
    const before = context.matchBefore(/[\w.]+|[[":]\s*/);
    if (!before && !context.explicit) return null;
    this.flush();
    const text = context.state.doc;
    const items = await this.client.complete(positionOf(text, context.pos)).catch(() => []);
    const edit = items[0]?.textEdit;
    if (!edit) return null;
    return {
      from: offsetOf(text, edit.range.start),
      options: items.map(optionOf),
      validFor: /^\w*$/,
    };
  }
}

function optionOf({ label, kind, detail, documentation }: CompletionItem): Completion {
  return {
    label,
    type: kTypes[kind] ?? "text",
    ...(detail ? { detail } : {}),
    ...(documentation ? { info: () => markdownToDom(documentation.value) } : {}),
  };
}
