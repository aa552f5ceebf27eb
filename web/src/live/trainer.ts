// The trainer on the other side: its commands, its events, and what is seen of the robot.

const token = (): string => new URLSearchParams(location.search).get("token") ?? "";

export type Json = Record<string, unknown>;

interface Reply<Value> {
  ok: boolean;
  value: Value;
  error: string;
}

/** Calls a command of docs/api.md; throws an Error with its reason where the trainer does not do it. */
export async function ask<Value = Json>(command: string, args?: Json): Promise<Value> {
  const response = await fetch(`/api/${command}`, {
    method: args ? "POST" : "GET",
    headers: { Authorization: `Bearer ${token()}` },
    ...(args ? { body: JSON.stringify(args) } : {}),
  });
  const reply = (await response.json()) as Reply<Value>;
  if (!reply.ok) throw new Error(reply.error);
  return reply.value;
}

export const addressOf = (path: string): string => `${path}?token=${encodeURIComponent(token())}`;

/** A WebSocket of the trainer. */
export function openSocket(path: string): WebSocket {
  const socket = new WebSocket(`ws://${location.host}${addressOf(path)}`);
  socket.binaryType = "arraybuffer";
  return socket;
}

const kBetweenTries = 1000; // [ms]

/** A WebSocket that is opened again whenever it is lost: a trainer that crashes starts again. */
export class LastingSocket {
  private socket: WebSocket | undefined;

  constructor(
    private readonly path: string,
    private readonly listeners: {
      onOpen?: () => void;
      onLost?: () => void;
      onMessage: (data: string | ArrayBuffer) => void;
    },
  ) {
    this.open();
  }

  /** Nothing is sent while the connection is lost: who listens says it again when it is open. */
  send(text: string): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(text);
  }

  private open(): void {
    const socket = openSocket(this.path);
    this.socket = socket;
    socket.addEventListener("open", () => this.listeners.onOpen?.());
    socket.addEventListener("message", ({ data }) => this.listeners.onMessage(data));
    socket.addEventListener("close", () => {
      this.listeners.onLost?.();
      window.setTimeout(() => this.open(), kBetweenTries);
    });
  }
}
