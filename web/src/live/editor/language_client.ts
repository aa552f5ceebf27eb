// A client of the language server that the trainer starts for this page, for one text.

import { LastingSocket } from "../trainer.ts";
import type { KnownNumbers, LetWorth } from "./lets.ts";
import type { TaskPage } from "./task_page.ts";

export interface Position {
  line: number; // from 0
  character: number; // UTF-16, as strings have it
}
export interface Range {
  start: Position;
  end: Position;
}
export interface TextEdit {
  range: Range;
  newText: string;
}
export interface LspDiagnostic {
  range: Range;
  severity: number; // 1: error
  code: string;
  message: string;
  data?: { fixes: (TextEdit & { title: string })[] };
}
export interface Markup {
  value: string;
}
export interface CompletionItem {
  label: string;
  kind: number;
  detail?: string;
  documentation?: Markup;
  textEdit?: TextEdit;
}

interface Message {
  id?: number;
  method?: string;
  params?: unknown;
  result?: unknown;
  error?: { message: string };
}
interface Waiting {
  resolve: (result: unknown) => void;
  reject: (error: Error) => void;
}

export class LanguageClient {
  private readonly socket: LastingSocket;
  private readonly waiting = new Map<number, Waiting>();
  private lastId = 0;
  private version = 0;
  private isOpen = false;

  /** `textOf`: the text as it is now. */
  constructor(
    private readonly uri: string,
    private readonly textOf: () => string,
    private readonly onDiagnostics: (diagnostics: LspDiagnostic[]) => void,
  ) {
    this.socket = new LastingSocket("/api/language", {
      onOpen: () => void this.begin(),
      onLost: () => this.lose(),
      onMessage: (data) => this.take(JSON.parse(data as string) as Message),
    });
  }

  /** To be called when the text has changed. */
  change(): void {
    if (!this.isOpen) return;
    this.notify("textDocument/didChange", {
      textDocument: { uri: this.uri, version: ++this.version },
      contentChanges: [{ text: this.textOf() }],
    });
  }

  hover(position: Position): Promise<{ contents: Markup; range?: Range } | null> {
    return this.ask("textDocument/hover", { position });
  }
  async complete(position: Position): Promise<CompletionItem[]> {
    const list = await this.ask<{ items: CompletionItem[] }>("textDocument/completion", { position });
    return list.items;
  }
  format(): Promise<TextEdit[] | null> {
    return this.ask("textDocument/formatting", { options: { tabSize: 2, insertSpaces: true } });
  }

  /** What `taskc doc` says of the text; null while it has errors. */
  page(): Promise<TaskPage | null> {
    return this.ask("task/page", {});
  }

  /** What its lets are worth where the numbers are `known`; null while the text has errors. */
  lets(known: KnownNumbers): Promise<LetWorth[] | null> {
    return this.ask("task/lets", { known });
  }

  private ask<Result>(method: string, params: object): Promise<Result> {
    if (!this.isOpen) return Promise.reject(new Error("the language server is not there yet"));
    return this.request(method, { textDocument: { uri: this.uri }, ...params });
  }

  private async begin(): Promise<void> {
    await this.request("initialize", { processId: null, rootUri: null, capabilities: {} });
    this.notify("initialized", {});
    const document = { uri: this.uri, languageId: "task", version: ++this.version };
    this.notify("textDocument/didOpen", { textDocument: { ...document, text: this.textOf() } });
    this.isOpen = true;
  }

  private lose(): void {
    this.isOpen = false;
    for (const { reject } of this.waiting.values()) reject(new Error("the connection is lost"));
    this.waiting.clear();
  }

  private request<Result>(method: string, params: object): Promise<Result> {
    const id = ++this.lastId;
    const answer = new Promise<unknown>((resolve, reject) =>
      this.waiting.set(id, { resolve, reject }),
    );
    this.send({ id, method, params });
    return answer as Promise<Result>;
  }

  private notify(method: string, params: object): void {
    this.send({ method, params });
  }

  private send(message: Message): void {
    this.socket.send(JSON.stringify({ jsonrpc: "2.0", ...message }));
  }

  private take({ id, method, params, result, error }: Message): void {
    if (method === "textDocument/publishDiagnostics") {
      const { uri, diagnostics } = params as { uri: string; diagnostics: LspDiagnostic[] };
      if (uri === this.uri) this.onDiagnostics(diagnostics);
      return;
    }
    if (id === undefined || method !== undefined) return;
    const waiting = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) waiting?.reject(new Error(error.message));
    else waiting?.resolve(result);
  }
}
