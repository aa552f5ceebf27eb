// Numbers, durations and the agent as text.

import type { AgentModule } from "./report_data.ts";

const kMinus = "\u2212";
const kThinSpace = "\u202f";

/** `value` with about four significant digits; "–" where there is none. */
export function formatNumber(value: number | undefined): string {
  if (value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e7)) {
    return value.toExponential(2).replace(/-/g, kMinus);
  }
  const decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : 3;
  return group(size.toFixed(decimals), value < 0);
}

/** A round number on an axis, without digits that say nothing: "0.5", "12 000", "1e−9". */
export function formatTick(value: number): string {
  if (Number.isInteger(value) && Math.abs(value) < 1e7) return formatCount(value);
  return formatNumber(value).replace(/(\.\d*?)0+(?=e|$)/, "$1").replace(/\.(?=e|$)/, "");
}

/** Such as a length [m] to the millimeter. */
export const formatThousandths = (value: number): string =>
  (Math.round(value * 1000) / 1000 + 0).toFixed(3).replace("-", kMinus);

/** `value` (a whole number) with its thousands set apart. */
export function formatCount(value: number): string {
  return group(Math.abs(Math.round(value)).toString(), value < 0);
}

function group(digits: string, negative: boolean): string {
  const [whole = "", fraction] = digits.split(".");
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, kThinSpace) : whole;
  return (negative ? kMinus : "") + grouped + (fraction === undefined ? "" : `.${fraction}`);
}

/** A duration [s] in its two largest units. */
export function formatDuration(seconds: number): string {
  if (!Number.isFinite(seconds)) return "–";
  if (seconds < 60) return `${formatNumber(seconds)} s`;
  const whole = Math.round(seconds);
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  if (hours === 0) return `${minutes} min ${whole % 60} s`;
  return `${formatCount(hours)} h ${minutes} min`;
}

/** One that is only estimated: no more exact than it is worth, and short. */
export function formatEstimate(seconds: number): string {
  if (seconds < 60) return `${Math.ceil(seconds)} s`;
  if (!(seconds >= 600)) return formatDuration(Math.round(seconds));
  const minutes = Math.round(seconds / 60);
  if (minutes < 60) return `${minutes} min`;
  const hours = Math.floor(minutes / 60);
  return hours < 10 ? `${hours} h ${minutes % 60} min` : `${formatCount(Math.round(minutes / 60))} h`;
}

/** How many times as much: "4.9", "132". */
export const formatRatio = (ratio: number): string =>
  ratio < 9.95 ? ratio.toFixed(1) : formatCount(Math.round(ratio));

/** "2026-01-31T12:30:59Z" without the seconds, for people. */
export const formatDate = (iso: string | undefined): string =>
  (iso ?? "").replace(/^(\d{4}-\d{2}-\d{2})T(\d{2}:\d{2}).*Z$/, "$1 $2 UTC");

/** A moment of a replay [s], always as wide as the longest one of `duration`. */
export function formatTime(seconds: number, duration: number): string {
  return seconds.toFixed(2).padStart(duration.toFixed(2).length, "\u2007");
}

/** "jumped [m]"; the name alone where there is no unit. */
export const withUnit = ({ name, unit }: { name: string; unit: string }): string =>
  unit ? `${name} [${unit}]` : name;

/** "failure: it has fallen" */
export const endInWords = ({ kind, reason }: { kind: string; reason: string }): string =>
  reason ? `${kind}: ${reason}` : kind;

const text = (value: unknown): string => String(value ?? "");

const kModuleWords: Record<string, (module: AgentModule) => string> = {
  PengQLambda: () => "Peng’s Q(λ)",
  MotionSearch: () => "motion search (CMA-ES)",
  MotionPlayer: (module) => {
    const kind = module["kind"] === "one_shot" ? "motions done once" : "periodic motions";
    const dof = text(module["dof"]);
    return dof === "all" ? `${kind} of all joints` : `${kind}, DoF configuration ${dof}`;
  },
  Dcob: (module) => (module["target"] === "state" ? "DCOB" : "DCOB-Q"),
  NgNet: (module) => `Gaussian network ${text(module["net"])}`.trim(),
  Ppo: () => "PPO",
  JointOffsets: (module) => {
    const dof = text(module["dof"]);
    return dof === "all" ? "offsets of all joints" : `joint offsets, DoF configuration ${dof}`;
  },
  DofState: (module) => `DoF configuration ${text(module["dof"])}`.trim(),
};

/** Learner, action space, features and state of the agent; a type without words by its name. */
export function agentInWords(modules: Record<string, AgentModule>): string {
  return ["learner", "action_space", "features", "state"]
    .map((name) => modules[name])
    .filter((module): module is AgentModule => module?.type !== undefined)
    .map((module) => kModuleWords[module.type as string]?.(module) ?? text(module.type))
    .join(" · ");
}
