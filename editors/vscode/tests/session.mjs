// A whole session of `taskc lsp` with the client that editors use.
// The environment variable TASKC_SESSION holds the program and the folder of robots: "TASKC|ROBOTS".
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {mkdtemp, rm} from 'node:fs/promises';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {test} from 'node:test';
import {pathToFileURL} from 'node:url';

const require = createRequire(join(process.cwd(), 'package.json'));
const protocol = require('vscode-languageserver-protocol/node');
const [taskc, robots] = process.env.TASKC_SESSION.split('|');

const kTask = `/// Stand.
task standing for humanoid

/// The price of a fall.
param price: real = 4 in 0 .. 20
memory fallen: bool = false per action

on end_of_time_step {
  let height = base.position.z
  reward rate up = height / 1 m  // größer ist besser 😀
  if not fallen and contact[head] {
    fallen = true
    reward fall = -price
  }
  if time > 5 s { truncate_episode "time is up" }
}
`;

// The place of a word of the text, counted as the protocol does: JavaScript's own units are UTF-16.
function placeOf(text, word, offset = 0) {
  const lines = text.slice(0, text.indexOf(word) + offset).split('\n');
  return {line: lines.length - 1, character: lines.at(-1).length};
}

async function withEditor(use) {
  const folder = await mkdtemp(join(tmpdir(), 'taskc-editor-'));
  const server = spawn(taskc, ['lsp', '--stdio', '--robots', robots]);
  const connection = protocol.createProtocolConnection(
      new protocol.StreamMessageReader(server.stdout),
      new protocol.StreamMessageWriter(server.stdin));
  const errors = [];
  server.stderr.on('data', (data) => errors.push(String(data)));
  const exited = new Promise((resolve) => server.on('exit', resolve));
  const published = new Map();
  const waiting = [];
  connection.onNotification(protocol.PublishDiagnosticsNotification.type, (params) => {
    published.set(params.uri, params);
    for (const check of waiting) check();
  });
  connection.listen();
  const editor = {
    connection,
    folder,
    uriOf: (name) => pathToFileURL(join(folder, name)).href,
    // The diagnostics of a version of a file, as soon as they are there.
    diagnostics: (uri, version) => new Promise((resolve) => {
      const check = () => {
        const params = published.get(uri);
        if (params?.version === version) resolve(params.diagnostics);
      };
      waiting.push(check);
      check();
    }),
    open: async (name, text) => {
      await connection.sendNotification(protocol.DidOpenTextDocumentNotification.type, {
        textDocument: {uri: editor.uriOf(name), languageId: 'task', version: 1, text},
      });
      return {textDocument: {uri: editor.uriOf(name)}};
    },
  };
  const greeting = await connection.sendRequest(protocol.InitializeRequest.type, {
    processId: process.pid,
    rootUri: pathToFileURL(folder).href,
    capabilities: {},
    workspaceFolders: [{uri: pathToFileURL(folder).href, name: 'tasks'}],
  });
  await connection.sendNotification(protocol.InitializedNotification.type, {});
  try {
    await use(editor, greeting);
    await connection.sendRequest(protocol.ShutdownRequest.type);
    await connection.sendNotification(protocol.ExitNotification.type);
    assert.equal(await exited, 0);
    assert.equal(errors.join(''), '');
  } finally {
    connection.dispose();
    server.kill();
    await rm(folder, {recursive: true});
  }
}

test('a session from the first question to the last', () => withEditor(async (editor, greeting) => {
  assert.equal(greeting.capabilities.positionEncoding, 'utf-16');
  assert.equal(greeting.serverInfo.name, 'taskc');
  const file = await editor.open('standing.task', kTask);
  const {uri} = file.textDocument;
  assert.deepEqual(await editor.diagnostics(uri, 1), []);
  const {connection} = editor;

  const hover = await connection.sendRequest(
      protocol.HoverRequest.type, {...file, position: placeOf(kTask, '-price', 2)});
  assert.match(hover.contents.value, /param price: real = 4[^]*The price of a fall/);

  const definition = await connection.sendRequest(
      protocol.DefinitionRequest.type, {...file, position: placeOf(kTask, '-price', 2)});
  assert.deepEqual(definition.range.start, placeOf(kTask, 'price:'));

  const references = await connection.sendRequest(protocol.ReferencesRequest.type, {
    ...file, position: placeOf(kTask, 'fallen:'), context: {includeDeclaration: true},
  });
  assert.equal(references.length, 3);

  const completion = await connection.sendRequest(
      protocol.CompletionRequest.type, {...file, position: placeOf(kTask, 'base.position', 5)});
  assert.ok(completion.items.some((item) => item.label === 'velocity'));

  const signature = await connection.sendRequest(
      protocol.SignatureHelpRequest.type, {...file, position: placeOf(kTask, 'contact')});
  assert.equal(signature, null);

  const symbols = await connection.sendRequest(protocol.DocumentSymbolRequest.type, file);
  assert.deepEqual(symbols.map((symbol) => symbol.name),
      ['standing', 'price', 'fallen', 'end_of_time_step']);

  // An edit behind characters beyond ASCII, within the line.
  const place = placeOf(kTask, '😀');
  await connection.sendNotification(protocol.DidChangeTextDocumentNotification.type, {
    textDocument: {uri, version: 2},
    contentChanges: [{
      range: {start: place, end: {line: place.line, character: place.character + 2}},
      text: '\n  reward bad = nothing',
    }],
  });
  const [wrong] = await editor.diagnostics(uri, 2);
  assert.equal(wrong.code, 'E0201');
  assert.equal(wrong.range.start.line, place.line + 1);
  assert.match(wrong.codeDescription.href, /diagnostics\.md#e0201/);

  const rename = await connection.sendRequest(protocol.RenameRequest.type, {
    ...file, position: placeOf(kTask, 'fallen:'), newName: 'has_fallen',
  });
  assert.equal(rename.changes[uri].length, 3);
  await assert.rejects(connection.sendRequest(protocol.RenameRequest.type, {
    ...file, position: placeOf(kTask, 'fallen:'), newName: 'price',
  }), /price/);

  await connection.sendNotification(protocol.DidChangeTextDocumentNotification.type, {
    textDocument: {uri, version: 3}, contentChanges: [{text: 'task  standing\nmemory a:int=0\n'}],
  });
  const edits = await connection.sendRequest(
      protocol.DocumentFormattingRequest.type, {...file, options: {tabSize: 2, insertSpaces: true}});
  assert.equal(edits[0].newText, 'task standing\nmemory a: int = 0\n');

  await connection.sendNotification(protocol.DidCloseTextDocumentNotification.type, file);
}));

test('a question that cannot be answered does not end the session', () => withEditor(async (editor) => {
  await assert.rejects(editor.connection.sendRequest('textDocument/unheardOf', {}), {code: -32601});
  await assert.rejects(editor.connection.sendRequest(protocol.HoverRequest.type, {
    textDocument: {uri: editor.uriOf('absent.task')}, position: {line: 0, character: 0},
  }));
  const file = await editor.open('broken.task', 'task broken for humanoid\non end_of_action {\n  let a = base.');
  assert.notEqual((await editor.diagnostics(file.textDocument.uri, 1)).length, 0);
  const completion = await editor.connection.sendRequest(
      protocol.CompletionRequest.type, {...file, position: {line: 2, character: 15}});
  assert.ok(completion.items.some((item) => item.label === 'up'));
}));
