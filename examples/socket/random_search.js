// Searches for a good linear policy in a task that another program offers, by JSON:
//
//   trainer environment TASK --socket PATH
//   node random_search.js PATH EPISODES
const net = require("node:net");
const readline = require("node:readline");

class Environment {
  constructor(path) {
    this.socket = net.createConnection(path);
    this.lines = readline.createInterface({ input: this.socket })[Symbol.asyncIterator]();
  }

  async read() {
    const { value, done } = await this.lines.next();
    if (done) throw new Error("the environment is gone");
    const reply = JSON.parse(value);
    if (reply.error) throw new Error(reply.error);
    return reply;
  }

  ask(request) {
    this.socket.write(JSON.stringify(request) + "\n");
    return this.read();
  }
}

const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

async function run(environment, policy) {
  let reply = await environment.ask({ reset: { seed: 1 } });
  while (!reply.end) {
    const action = policy.map((row) => dot(row, reply.observation));
    reply = await environment.ask({ step: action });
  }
  return reply.return;
}

async function main(path, episodes) {
  const environment = new Environment(path);
  const { action, observation } = await environment.read();
  const size = observation.reduce((sum, value) => sum + value.size, 0);
  let best = action.low.map(() => Array(size).fill(0));
  let bestReturn = await run(environment, best);
  const first = bestReturn;
  for (let episode = 0; episode < episodes; ++episode) {
    const policy = best.map((row) => row.map((w) => w + Math.random() - 0.5));
    const total = await run(environment, policy);
    if (total <= bestReturn) continue;
    [best, bestReturn] = [policy, total];
    console.log(`episode ${episode}: ${total.toFixed(3)}`);
  }
  console.log(`from ${first.toFixed(3)} to ${bestReturn.toFixed(3)}`);
  environment.socket.end();
}

main(process.argv[2], Number(process.argv[3]));
