// The colors: every word of the language has one, and samples are taken apart as they should be.
// The environment variable TASKC_SOURCES holds the project's folder.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {test} from 'node:test';

const require = createRequire(join(process.cwd(), 'package.json'));
const {INITIAL, Registry, parseRawGrammar} = require('vscode-textmate');
const oniguruma = require('vscode-oniguruma');

const sources = process.env.TASKC_SOURCES;
const kGrammar = join(sources, 'editors/vscode/syntaxes/task.tmLanguage.json');

async function loadGrammar() {
  const wasm = readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm'));
  await oniguruma.loadWASM(wasm);
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => parseRawGrammar(readFileSync(kGrammar, 'utf8'), kGrammar),
  });
  return registry.loadGrammar('source.task');
}
const grammar = await loadGrammar();

// The innermost scope of a part of a line.
function scopeOf(line, part) {
  const begin = line.indexOf(part);
  for (const token of grammar.tokenizeLine(line, INITIAL).tokens) {
    if (token.startIndex <= begin && begin < token.endIndex) return token.scopes.at(-1);
  }
  return undefined;
}

const samples = [
  ['/// Move forward.', 'Move', 'comment.line.documentation.task'],
  ['let a = 1 // why', 'why', 'comment.line.double-slash.task'],
  ['task crawling for humanoid', 'crawling', 'entity.name.class.task'],
  ['task crawling for humanoid', 'humanoid', 'support.class.robot.task'],
  ['task a extends "b.task"', 'extends', 'keyword.declaration.task'],
  ['param weight: real [1/s] = 4 / s in 0 .. 2', 'param', 'keyword.declaration.task'],
  ['param weight: real [1/s] = 4 / s in 0 .. 2', 'real', 'support.type.task'],
  ['  reward rate forward = 0.25 / 5 ms * dot(a, b)', 'reward', 'keyword.control.reward.task'],
  ['  reward rate forward = 0.25 / 5 ms * dot(a, b)', 'rate', 'storage.modifier.rate.task'],
  ['reward potential near = -norm(place)', 'potential', 'storage.modifier.rate.task'],
  ['  reward rate forward = 0.25 / 5 ms * dot(a, b)', 'ms', 'keyword.other.unit.task'],
  ['  reward rate forward = 0.25 / 5 ms * dot(a, b)', 'dot', 'support.function.builtin.task'],
  ['  sum += reward', 'reward', 'variable.language.task'],
  ['  log max speed = log(x)', 'log', 'keyword.control.log.task'],
  ['  let y = log(x)', 'log', 'support.function.builtin.task'],
  ['metric min height = min(a, b)', 'min', 'storage.modifier.reduction.task'],
  ['memory fallen: bool = false per action', 'action', 'storage.modifier.scope.task'],
  ['on end_of_time_step {', 'end_of_time_step', 'entity.name.function.event.task'],
  ['  end_episode failure "falls"', 'failure', 'constant.language.outcome.task'],
  ['  end_episode failure "falls"', 'falls', 'string.quoted.double.task'],
  ['after_end continue', 'after_end', 'keyword.declaration.task'],
  ['after_end continue', 'continue', 'constant.language.task'],
  ['override fn near(d: real) -> real = d', 'near', 'entity.name.function.task'],
  ['const reach: real [m] = 5 cm', 'const', 'keyword.declaration.task'],
  ['override set supports = feet', 'set', 'keyword.declaration.task'],
  ['  expect total(a) == 1 within 1e-9', 'within', 'keyword.operator.word.task'],
  ['allow W0706, W0712', 'W0712', 'constant.other.warning.task'],
];

test('samples have the scopes that they should', () => {
  for (const [line, part, scope] of samples) assert.equal(scopeOf(line, part), scope, `${part} in ${line}`);
});

test('every word of the language stands in the grammar', () => {
  const colors = readFileSync(kGrammar, 'utf8');
  const rules = readFileSync(join(sources, 'grammar/Task.g4'), 'utf8');
  const words = readFileSync(join(sources, 'compiler/syntax/words.h'), 'utf8');
  const table = readFileSync(join(sources, 'compiler/check/builtin_table.def'), 'utf8');
  const builtins = [...table.matchAll(/^(?:BUILTIN|COMPOSITE|CONSTRUCTOR)\(.*?"(\w+)"/gm)].map((match) => match[1]);
  const names = [
    ...[...rules.matchAll(/'([A-Za-z_]+)'/g)].map((match) => match[1]),
    ...[...words.matchAll(/\{"(\w+)",/g)].map((match) => match[1]),
    ...builtins,
  ];
  assert.ok(builtins.length > 40);
  assert.ok(names.length > builtins.length + 60);
  const missing = names.filter((name) => !new RegExp(`\\b${name}\\b`).test(colors));
  assert.deepEqual(missing, []);
});
