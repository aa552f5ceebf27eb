// Lets ONNX Runtime decide what a robot has decided, and prints the largest difference.
//
//   node decide.mjs POLICY.onnx DECISIONS.csv
//
// The exit status is 1 where a number differs by more than 1e-5.
import { readFile } from "node:fs/promises";
import { InferenceSession, Tensor } from "onnxruntime-node";

const [model, decisions] = process.argv.slice(2);
const [heading, ...lines] = (await readFile(decisions, "utf8")).trimEnd().split("\n");
const columns = [...heading.matchAll(/"(?:[^"]|"")*"|[^,]+/g)].map(([name]) => name.replace(/^"/, ""));
const rows = lines.map((line) => line.split(",").map(Number));

// The numbers of all decisions whose columns begin with "NAME/", one decision after the other.
function numbers(name) {
  const places = [...columns.keys()].filter((i) => columns[i].startsWith(`${name}/`));
  return { size: places.length, data: Float32Array.from(rows.flatMap((row) => places.map((i) => row[i]))) };
}

const session = await InferenceSession.create(model);
const { size, data } = numbers("observation");
const outputs = await session.run({ observation: new Tensor("float32", data, [rows.length, size]) });
let largest = 0;
for (const name of session.outputNames) {
  const decided = numbers(name);
  const computed = outputs[name];
  if (decided.data.length === 0 || String(computed.dims) !== String([rows.length, decided.size])) {
    throw new Error(`${name} has the shape [${computed.dims}], not [${rows.length}, ${decided.size}]`);
  }
  decided.data.forEach((value, i) => {
    largest = Math.max(largest, Math.abs(value - computed.data[i]));
  });
}
console.log(`${rows.length} decisions, ${session.outputNames.join(" and ")}: ${largest}`);
process.exitCode = largest <= 1e-5 ? 0 : 1; // also where it is not a number
