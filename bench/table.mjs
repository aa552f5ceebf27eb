// Makes one table of the results that benchmark programs have written (JSON of Google Benchmark).
//
//   node bench/table.mjs FOLDER RESULT.json...     writes FOLDER/results.md and FOLDER/results.json
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { cpus, totalmem } from "node:os";

const [folder, ...files] = process.argv.slice(2);

// What Google Benchmark says of every benchmark; all other keys are its own counters.
const commonKeys = new Set([
  "name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions",
  "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit",
  "aggregate_name", "aggregate_unit",
]);

// Of repeated benchmarks only the median counts.
const counts = (run) => run.run_type !== "aggregate" || run.aggregate_name === "median";

// Benchmarks with a time of their own choosing report it as real time.
const timeOf = (run) => (run.name.includes("/manual_time") ? run.real_time : run.cpu_time);

const short = (value) =>
  Number.isInteger(value) && Math.abs(value) < 1e6 ? String(value) : Number(value.toPrecision(3)).toString();

function rowsOf(file) {
  const { benchmarks } = JSON.parse(readFileSync(file, "utf8"));
  return benchmarks.filter(counts).map((run) => ({
    program: basename(file, ".json"),
    name: run.name.replace(/\/(manual_time|iterations:\d+|min_time:[\d.]+|repeats:\d+_median)/g, ""),
    time: timeOf(run),
    unit: run.time_unit,
    counters: Object.fromEntries(
      Object.entries(run).filter(([key, value]) => !commonKeys.has(key) && Number.isFinite(value)),
    ),
  }));
}

function markdown(machine, rows) {
  const lines = [`${machine.name}, ${machine.cores} cores, ${machine.memory} GB; ${machine.date}. CPU time.`, ""];
  for (const program of new Set(rows.map((row) => row.program))) {
    lines.push(`## \`${program}\``, "", "| benchmark | time | counters |", "|---|---|---|");
    for (const row of rows.filter((each) => each.program === program)) {
      const counters = Object.entries(row.counters).map(([key, value]) => `${key} ${short(value)}`);
      lines.push(`| ${row.name} | ${short(row.time)} ${row.unit} | ${counters.join(", ")} |`);
    }
    lines.push("");
  }
  return lines.join("\n");
}

const machine = {
  name: cpus()[0].model,
  cores: cpus().length,
  memory: Math.round(totalmem() / 2 ** 30),
  date: new Date().toISOString().slice(0, 10),
};
const rows = files.flatMap(rowsOf);
writeFileSync(join(folder, "results.json"), JSON.stringify({ machine, results: rows }, null, 2) + "\n");
writeFileSync(join(folder, "results.md"), markdown(machine, rows));
console.log(`written: ${join(folder, "results.md")}, ${join(folder, "results.json")}`);
