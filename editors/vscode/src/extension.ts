// Starts `taskc lsp` and lets the editor talk to it.
import {commands, type ExtensionContext, window, workspace} from 'vscode';
import {LanguageClient, type LanguageClientOptions, type ServerOptions} from 'vscode-languageclient/node';

let client: LanguageClient | undefined;

function serverOptions(): ServerOptions {
  const settings = workspace.getConfiguration('taskc');
  const robots = settings.get<string>('robots', '');
  return {
    command: settings.get<string>('path', 'taskc'),
    args: robots === '' ? ['lsp'] : ['lsp', '--robots', robots],
  };
}

async function start(): Promise<void> {
  const options: LanguageClientOptions = {
    documentSelector: [{language: 'task'}],
    synchronize: {fileEvents: workspace.createFileSystemWatcher('**/{*.task,robot.toml}')},
  };
  client = new LanguageClient('taskc', 'taskc', serverOptions(), options);
  try {
    await client.start();
  } catch (error) {
    void window.showErrorMessage(
        `taskc cannot be started; the setting taskc.path says where it is. (${String(error)})`);
  }
}

async function stop(): Promise<void> {
  const last = client;
  client = undefined;
  if (last?.isRunning()) await last.stop();
}

async function restart(): Promise<void> {
  await stop();
  await start();
}

export async function activate(context: ExtensionContext): Promise<void> {
  context.subscriptions.push(
      commands.registerCommand('taskc.restart', restart),
      workspace.onDidChangeConfiguration((change) => {
        if (change.affectsConfiguration('taskc')) void restart();
      }));
  await start();
}

export function deactivate(): Promise<void> {
  return stop();
}
