"""Searches for a good linear policy in a task that another program offers, binary messages:

    trainer environment TASK --socket PATH
    python3 random_search.py PATH EPISODES
"""
import json
import random
import socket
import struct
import sys


class Environment:
    def __init__(self, path):
        connection = socket.socket(socket.AF_UNIX)
        connection.connect(path)
        self.stream = connection.makefile("rwb")
        greeting = json.loads(self.stream.readline())
        self.action_size = len(greeting["action"]["low"])
        self.size = sum(value["size"] for value in greeting["observation"])
        self.stream.write(b'{"format": "binary"}\n')

    def reset(self, seed):
        return self.ask(struct.pack("<BQ", 1, seed))[0]

    def step(self, action):
        return self.ask(struct.pack(f"<B{self.action_size}d", 2, *action))

    def ask(self, request):
        self.stream.write(request)
        self.stream.flush()
        reply = self.stream.read(9 + 8 * self.size)
        end, reward, *observation = struct.unpack(f"<Bd{self.size}d", reply)
        return observation, reward, end


def run(environment, policy):
    observation, total, end = environment.reset(seed=1), 0.0, 0
    while end == 0:  # 1 success, 2 failure, 3 truncated, 4 diverged
        action = [sum(w * x for w, x in zip(row, observation)) for row in policy]
        observation, reward, end = environment.step(action)
        total += reward
    return total


environment = Environment(sys.argv[1])
random.seed(1)
best = [[0.0] * environment.size for _ in range(environment.action_size)]
best_return = first = run(environment, best)
for episode in range(int(sys.argv[2])):
    policy = [[w + random.gauss(0, 0.3) for w in row] for row in best]
    total = run(environment, policy)
    if total > best_return:
        best, best_return = policy, total
        print(f"episode {episode}: {total:.3f}", flush=True)
print(f"from {first:.3f} to {best_return:.3f}")
