#!/usr/bin/env python3
"""Clients that a trainer must bear: many, fast, slow, oversized, strange.

    server_load.py RUN [--seconds N] [--rate N] [--connections N]

RUN is the folder of a run that a trainer trains. Prints one line of figures, or what was wrong and exits with 1:
what was not refused or not answered, memory that grew, or a run that stood still.
"""

import argparse
import asyncio
import json
import os
import time

PATIENCE = 60  # [s]; a busy machine is no mistake of the trainer
LIMITS = {"body": 1 << 20, "header": 16 << 10}  # bytes, as the server's own


class Trainer:
    def __init__(self, run):
        with open(os.path.join(run, "control.json")) as file:
            control = json.load(file)
        self.port = int(control["url"].rstrip("/").rsplit(":", 1)[1])
        self.token, self.pid = control["token"], control["pid"]

    def memory(self):
        """Resident, in MB."""
        with open(f"/proc/{self.pid}/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 1e6

    def files(self):
        return len(os.listdir(f"/proc/{self.pid}/fd"))

    def request(self, target="/api/status", host=None, origin=None, token=None, body=b"", length=None, filler=0):
        lines = [
            f"{'POST' if body or length else 'GET'} {target} HTTP/1.1",
            f"Host: {host or f'127.0.0.1:{self.port}'}",
            f"Authorization: Bearer {self.token if token is None else token}",
        ]
        if origin:
            lines.append(f"Origin: {origin}")
        if body or length:
            lines.append(f"Content-Length: {length or len(body)}")
        if filler:
            lines.append("X-Filler: " + "x" * filler)
        return "\r\n".join(lines).encode() + b"\r\n\r\n" + body

    async def connect(self):
        return await asyncio.open_connection("127.0.0.1", self.port)


async def response(reader):
    """The status and the body; (0, b"") where the other side has closed."""
    try:
        head = (await reader.readuntil(b"\r\n\r\n")).decode()
        length = int(next((line.split(":")[1] for line in head.lower().split("\r\n") if "content-length" in line), 0))
        return int(head.split()[1]), await reader.readexactly(length)
    except (asyncio.IncompleteReadError, ConnectionError):
        return 0, b""


async def ask(trainer, request):
    reader, writer = await trainer.connect()
    writer.write(request)
    answer = await asyncio.wait_for(response(reader), PATIENCE)
    writer.close()
    return answer


async def episode_of(trainer):
    value = json.loads((await ask(trainer, trainer.request()))[1])["value"]
    return value["episode"]


async def check_refusals(trainer):
    cases = [
        ("another host", trainer.request(host="evil.example"), 403),
        ("another origin", trainer.request(origin="http://evil.example"), 403),
        ("no token", trainer.request(token=""), 401),
        ("a wrong token", trainer.request(token="0" * 64), 401),
        ("a token in the address", trainer.request(f"/api/status?token={trainer.token}", token="x"), 401),
        ("an oversized body", trainer.request("/api/set", length=LIMITS["body"] + 1), 413),
        ("an oversized header", trainer.request(filler=LIMITS["header"]), 431),
        ("no HTTP", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\r\n\r\n", 400),
        ("a path above", trainer.request("/../../etc/passwd"), 404),
    ]
    for name, request, expected in cases:
        status, _ = await ask(trainer, request)
        assert status == expected, f"{name}: status {status}, expected {expected}"
    return len(cases)


async def send_steadily(trainer, rate, end, counts):
    """One request after the other over one connection."""
    reader, writer = await trainer.connect()
    request, due = trainer.request(), time.monotonic()
    while due < end:
        await asyncio.sleep(max(0, due - time.monotonic()))
        begin = time.monotonic()
        writer.write(request)
        status, _ = await response(reader)
        assert status == 200, f"a request was answered with status {status}"
        counts.append(time.monotonic() - begin)
        due = max(due + 1 / rate, begin)
    writer.close()


async def hold_open(trainer, end, counts):
    """A client that connects, and is told to go where there are too many."""
    reader, writer = await trainer.connect()
    try:
        first = await asyncio.wait_for(reader.read(64), max(0.1, end - time.monotonic()))
        counts["turned away"] += first.startswith(b"HTTP/1.1 503")
        counts["closed"] += first == b""
    except (asyncio.TimeoutError, ConnectionError):
        counts["kept"] += 1
    writer.close()


async def send_slowly(trainer, end):
    """A header of which a byte comes each second: closed when its time is over, not before it is whole."""
    reader, writer = await trainer.connect()
    begin = time.monotonic()
    for byte in trainer.request(filler=500):
        if time.monotonic() > end or reader.at_eof():
            break
        try:
            writer.write(bytes([byte]))
            await writer.drain()
            await asyncio.wait_for(reader.read(1), 1)
            break
        except asyncio.TimeoutError:
            continue
        except ConnectionError:
            break
    writer.close()
    return time.monotonic() - begin


async def until(holds, otherwise):
    end = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < end, otherwise
        await asyncio.sleep(0.2)


async def measure_alone(trainer, seconds):
    begin = await episode_of(trainer)
    await asyncio.sleep(seconds)
    return (await episode_of(trainer) - begin) / seconds


async def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("run")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--rate", type=float, default=1000)
    parser.add_argument("--connections", type=int, default=200)
    options = parser.parse_args()
    trainer = Trainer(options.run)
    refused = await check_refusals(trainer)
    alone = await measure_alone(trainer, min(10, options.seconds))
    memory, files, episode = trainer.memory(), trainer.files(), await episode_of(trainer)

    begin = time.monotonic()
    end = begin + options.seconds
    clients, latencies = 16, []
    idle = {"turned away": 0, "closed": 0, "kept": 0}
    steady = [asyncio.create_task(send_steadily(trainer, options.rate / clients, end, latencies)) for _ in range(clients)]
    await asyncio.sleep(0.2)
    slow = [asyncio.create_task(send_slowly(trainer, end)) for _ in range(8)]
    held = [asyncio.create_task(hold_open(trainer, end, idle)) for _ in range(options.connections - clients - len(slow))]
    await asyncio.gather(*steady)
    seconds = time.monotonic() - begin
    slow_seconds = max(await asyncio.gather(*slow))
    await asyncio.gather(*held)
    assert options.connections < 64 or idle["turned away"] > 0, "there is no limit on connections"
    assert slow_seconds < 45, f"a slow client was kept for {slow_seconds:.0f} s"

    busy = (await episode_of(trainer) - episode) / (time.monotonic() - begin)
    await asyncio.sleep(1)
    refused += await check_refusals(trainer)
    more = trainer.memory() - memory
    assert more < 8, f"memory has grown by {more:.1f} MB"
    await until(lambda: trainer.files() <= files + 2, f"{files} open files have become {trainer.files()}")
    now, patience = await episode_of(trainer), time.monotonic() + PATIENCE
    while await episode_of(trainer) == now:
        assert time.monotonic() < patience, "the run stands still"
        await asyncio.sleep(0.2)
    latencies.sort()
    print(
        f"{len(latencies) / seconds:.0f} requests a second for {seconds:.0f} s over {clients} of {options.connections} "
        f"connections ({idle['turned away']} turned away), half within {1000 * latencies[len(latencies) // 2]:.1f} ms, "
        f"99 % within {1000 * latencies[len(latencies) * 99 // 100]:.1f} ms; {refused} strange requests refused; "
        f"memory {more:+.1f} MB; {busy:.1f} episodes a second, {alone:.1f} before"
    )


try:
    asyncio.run(main())
except AssertionError as error:
    print(f"server_load.py: {error}")
    raise SystemExit(1)
