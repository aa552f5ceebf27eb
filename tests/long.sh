#!/usr/bin/env bash
# Attacks that take long, started by hand: docs/reliability.md says what they prove. Each part prints a
# line with its figures, and is not repeated when the script is called again after it was stopped.
#
#   tests/long.sh                      all parts
#   tests/long.sh kills flips          some: kills, swaps, studies, builds, flips, strangers, slurm,
#                                      power, disk, load, fuzz, soak
#   KILLS=1000 tests/long.sh kills     how often something is killed (200)
#   NAP=3000 tests/long.sh kills       how long it may work until then, at most, in ms (800)
#   STEP=1 tests/long.sh power disk    at which of the changes on the disk (every 17th byte of flips)
#   SECONDS_OF_LOAD=60                 of load
#   FUZZ=DIR, MINUTES=60               of fuzz: the fuzzers (build-fuzz/bin), how long each of them
#   HOURS=8 tests/long.sh soak         of everyday use
#   FOLDER=DIR, BIN=DIR, SEED=N        where it works (build/long), the programs, the random numbers
#
# rm -r build/long forgets what was done; AGAIN=1 does it again.
set -euo pipefail
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
bin=$(realpath "${BIN:-$root/build/bin}")
folder=${FOLDER:-$root/build/long}
kills=${KILLS:-200}
mkdir -p "$folder"
folder=$(realpath "$folder")
RANDOM=${SEED:-7}
task=$root/tests/runtime/trainer/tasks/leaning.task
parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(kills swaps studies builds flips strangers slurm power disk load fuzz soak)

# shellcheck source=tests/run_record.sh
source "$root/tests/run_record.sh"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
# Some time up to the next kill.
nap() {
  local ms=$((RANDOM % ${NAP:-800}))
  sleep "$((ms / 1000)).$(printf '%03d' $((ms % 1000)))"
}
# Kills prove something only of runs that get on between them.
expect_progress() {
  [ "$1" -ge $((kills / 4)) ] || fail "only $1 episodes between $kills kills; try a larger NAP"
}
# A process and all that it has started.
kill_tree() {
  local child
  for child in $(cat "/proc/$1/task/$1/children" 2>/dev/null); do kill_tree "$child"; done
  kill -KILL "$1" 2>/dev/null || true
}
expect_same() { is_same_run "$1" "$2" || fail "$1 is another run than $2"; }
episodes() { "$bin/trainer" show "$1" --json | sed -n 's/.*"episodes": \([0-9]*\).*/\1/p' | head -1; }

# A run whose trainer, or its guard, is killed at random instants is the run that was left alone.
part_kills() {
  local run=$folder/kills/run done=0 pid victim
  rm -rf "$folder/kills"
  mkdir -p "$folder/kills"
  local words=(--profile fast --episodes 1000000 --seed 3 --checkpoint-every 0.05 --record-every 7)
  "$bin/trainer" train "$task" "${words[@]}" --out "$run" --quiet 2>/dev/null &
  pid=$!
  while [ "$done" -lt "$kills" ]; do
    nap
    case $((RANDOM % 3)) in
      0) kill -KILL "$pid" 2>/dev/null || true ;;  # the guard: its child dies with it
      1)
        victim=$(cat "/proc/$pid/task/$pid/children" 2>/dev/null || true)
        kill -KILL ${victim:-$pid} 2>/dev/null || true
        ;;
      *) kill_tree "$pid" ;;
    esac
    wait "$pid" 2>/dev/null || true
    done=$((done + 1))
    if [ -s "$run/run.db" ]; then
      "$bin/trainer" resume "$run" --quiet 2>>"$folder/kills/errors" &
    else  # it was killed before there was a run
      "$bin/trainer" train "$task" "${words[@]}" --out "$run" --quiet 2>/dev/null &
    fi
    pid=$!
  done
  kill_tree "$pid"
  wait "$pid" 2>/dev/null || true
  local total
  total=$(episodes "$run")
  expect_progress "$total"
  total=$((total + 5))
  "$bin/trainer" resume "$run" --episodes "$total" --quiet
  "$bin/trainer" train "$task" "${words[@]:0:2}" --episodes "$total" "${words[@]:4}" \
    --out "$folder/kills/calm" --quiet
  expect_same "$run" "$folder/kills/calm"
  "$bin/trainer" reproduce "$run" --quiet || fail "reproduce $run"
  echo "$done kills of trainer and guard within $total episodes: every row and what was learned equal"
}

# The same while clients change the run, which then is the run of its record.
part_swaps() {
  local run=$folder/swaps/run done=0 pid client other=$root/tests/runtime/trainer/tasks/upright.task
  rm -rf "$folder/swaps"
  mkdir -p "$folder/swaps"
  "$bin/trainer" serve "$task" --profile fast --episodes 1000000 --checkpoint-every 0.05 \
    --out "$run" --quiet >/dev/null 2>&1 &
  pid=$!
  until [ -s "$run/run.db" ]; do sleep 0.05; done
  while [ "$done" -lt "$kills" ]; do
    (
      while :; do
        case $((RANDOM % 5)) in
          0) set -- swap task "$other" --now ;;
          1) set -- swap task "$task" --forget ;;
          2) set -- set task.limit "0.$((RANDOM % 8 + 1)) s" ;;
          3) set -- load "$other" as shadow ;;
          *) set -- unload shadow ;;
        esac
        "$bin/trainer" ctl --run "$run" "$@" >/dev/null 2>&1 || true
      done
    ) &
    client=$!
    nap
    kill_tree "$pid"
    kill_tree "$client"
    wait "$pid" "$client" 2>/dev/null || true
    done=$((done + 1))
    "$bin/trainer" serve "$run" --quiet >/dev/null 2>>"$folder/swaps/errors" &
    pid=$!
  done
  kill_tree "$pid"
  wait "$pid" 2>/dev/null || true
  local total
  total=$(episodes "$run")
  expect_progress "$total"
  "$bin/trainer" resume "$run" --episodes $((total + 5)) --quiet
  "$bin/trainer" reproduce "$run" >"$folder/swaps/text" || fail "$(cat "$folder/swaps/text")"
  echo "$done kills while clients change the run: $(tail -n 1 "$folder/swaps/text" | sed 's/.*record: //')"
}

# Supervisors of many runs, and their workers.
part_studies() {
  local done=0 pid victims victim
  rm -rf "$folder/studies"
  mkdir -p "$folder/studies"
  cat >"$folder/studies/study.toml" <<END
profile = "fast"
episodes = $((kills * 3 + 50))
seeds = "1..4"
[[experiments]]
task = "$task"
[[experiments]]
name = "long"
task = "$task"
settings = ["task.limit=0.6"]
END
  local words=(study "$folder/studies/study.toml" --jobs 2 --quiet)
  "$bin/trainer" "${words[@]}" --out "$folder/studies/killed" 2>/dev/null &
  pid=$!
  while [ "$done" -lt "$kills" ]; do
    nap
    victims=($(cat "/proc/$pid/task/$pid/children" 2>/dev/null || true) "$pid")
    victim=${victims[$((RANDOM % ${#victims[@]}))]}
    if [ "$victim" = "$pid" ]; then kill_tree "$pid"; else kill -KILL "$victim" 2>/dev/null || true; fi
    done=$((done + 1))
    if ! kill -0 "$pid" 2>/dev/null; then
      wait "$pid" 2>/dev/null || true
      "$bin/trainer" "${words[@]}" --out "$folder/studies/killed" 2>>"$folder/studies/errors" &
      pid=$!
    fi
  done
  wait "$pid" 2>/dev/null || true
  "$bin/trainer" "${words[@]}" --out "$folder/studies/killed"
  "$bin/trainer" "${words[@]}" --out "$folder/studies/calm"
  local run
  for run in "$folder"/studies/calm/*/seed*; do
    expect_same "$run" "$folder/studies/killed/${run#"$folder/studies/calm/"}"
  done
  echo "$done kills of supervisor and workers: 8 runs equal to those of a study that was left alone"
}

# A build that is killed leaves the old plugin, the new one or none, and nothing that hinders the next.
part_builds() {
  local done=0 pid old new now
  rm -rf "$folder/builds"
  mkdir -p "$folder/builds"
  cp "$task" "$folder/builds/a.task"
  local build=("$bin/taskc" build "$folder/builds/a.task" --cache "$folder/builds/cache"
    -o "$folder/builds/a.so")
  sum() { sha256sum <"$folder/builds/a.so" 2>/dev/null || echo none; }
  "${build[@]}" >/dev/null
  old=$(sum)
  while [ "$done" -lt "$kills" ]; do
    # Another task each time, so that it is compiled and not taken from the cache.
    sed "s/0.125/0.$((RANDOM + 1))/" "$task" >"$folder/builds/a.task"
    "${build[@]}" >/dev/null 2>&1 &
    pid=$!
    nap
    kill_tree "$pid"
    wait "$pid" 2>/dev/null || true
    done=$((done + 1))
    now=$(sum)
    "${build[@]}" >/dev/null || fail "the build after a kill"
    new=$(sum)
    [ "$now" = "$old" ] || [ "$now" = "$new" ] || fail "half a plugin after a kill"
    old=$new
  done
  echo "$done kills of taskc build: always the old plugin or the new one, $(
    find "$folder/builds/cache" -type f | wc -l) files in the cache"
}

# A plugin that says so when any of its code runs.
loud_plugin() {
  cat >"$folder/loud.c" <<'END'
#include <stdio.h>
#include <stdlib.h>
__attribute__((constructor)) static void shout(void) {
  const char* name = getenv("LOUD");
  FILE* file = name != NULL ? fopen(name, "a") : NULL;
  if (file != NULL) { fputs("ran\n", file); fclose(file); }
}
const void* taskc_plugin_get(void) { return NULL; }
END
  gcc -shared -fPIC -O1 -o "$1" "$folder/loud.c"
  "$bin/taskc" seal "$1" >/dev/null
}

# One byte of a plugin after the other is another one: it is refused, and nothing of it has run.
part_flips() {
  local plugin=$folder/flips/loud.so size at count=0
  rm -rf "$folder/flips"
  mkdir -p "$folder/flips"
  loud_plugin "$plugin"
  export LOUD=$folder/flips/ran
  "$bin/trainer" train "$plugin" --robot humanoid --no-sandbox --out "$folder/flips/run" >/dev/null 2>&1 || true
  [ -s "$LOUD" ] || fail "the plugin as it is was not loaded"
  rm "$LOUD"
  size=$(stat -c %s "$plugin")
  for ((at = 0; at < size; at += ${STEP:-17})); do
    cp "$plugin" "$folder/flips/other.so"
    printf '%b' "\\x$(printf '%02x' $((0x$(od -An -tx1 -j "$at" -N 1 "$plugin" | tr -d " ") ^ (1 << RANDOM % 8))))" |
      dd of="$folder/flips/other.so" bs=1 seek="$at" conv=notrunc status=none
    if "$bin/trainer" train "$folder/flips/other.so" --robot humanoid --no-sandbox --out "$folder/flips/run" \
      >/dev/null 2>"$folder/flips/errors"; then
      fail "byte $at flipped, and the plugin is trained"
    fi
    [ ! -e "$LOUD" ] || fail "byte $at flipped, and code of the plugin has run"
    count=$((count + 1))
  done
  unset LOUD
  echo "$count of $size bytes flipped, one at a time: all refused, and no code has run"
}

# What only looks at a run of a stranger never loads his plugins.
part_strangers() {
  local run=$folder/strangers/run count=0 words
  rm -rf "$folder/strangers"
  mkdir -p "$folder/strangers"
  "$bin/trainer" train "$task" --profile fast --episodes 4 --out "$run" --quiet
  local plugin
  plugin=$(ls "$run"/plugin-*.so)
  loud_plugin "$plugin"
  export LOUD=$folder/strangers/ran
  cd "$folder/strangers"
  while read -r words; do
    eval "$bin/trainer $words" >/dev/null 2>&1 || fail "trainer $words"
    [ ! -e "$LOUD" ] || fail "trainer $words: it has run code of the stranger's plugin"
    count=$((count + 1))
  done <<END
show run
show run --json
show .
report run
report . -o all.html
report . --json
export run --csv a.csv
export run --tensorboard board
export run --mcap a.mcap
snapshots run -o a.png
END
  cd "$root"
  unset LOUD
  echo "$count ways to look at a run whose plugin was replaced: none has run its code"
}

# The library that makes a program see another disk (tests/disk/disk_faults.c).
disk_library() { gcc -shared -fPIC -O1 -o "$1" "$root/tests/disk/disk_faults.c" -ldl; }
# A small run in $1, from its start or where it stands.
small_words=(--profile fast --episodes 6 --seed 3 --checkpoint-every 0 --record-every 2)
train_or_resume() {
  if [ -e "$1/run.db" ]; then
    "$bin/trainer" resume "$1" --quiet
  else
    "$bin/trainer" train "$folder/small.so" "${small_words[@]}" --out "$1" --quiet
  fi
}

# A machine that loses its power after any change on the disk: what was not synced is gone, or half
# of it. The run that goes on from there is the one that was left alone; so is the next build.
part_power() {
  local log=$folder/power/log total at seed count=0 begun=0
  rm -rf "$folder/power"
  mkdir -p "$folder/power/disk"
  disk_library "$folder/power/disk.so"
  "$bin/taskc" build "$task" -o "$folder/small.so" >/dev/null
  train_or_resume "$folder/power/calm"
  DISK_FOLDER=$folder/power/disk DISK_LOG=$log LD_PRELOAD=$folder/power/disk.so \
    train_or_resume "$folder/power/disk/run"
  expect_same "$folder/power/disk/run" "$folder/power/calm"
  total=$("$root/tests/disk/power_cut.py" count "$log")
  [ "$total" -gt 50 ] || fail "only $total changes on the disk were seen"
  for ((at = 0; at <= total; at += ${STEP:-1})); do
    for seed in 0 $((at + 1)); do
      rm -rf "$folder/power/cut"
      "$root/tests/disk/power_cut.py" make "$log" "$at" "$seed" "$folder/power/disk" "$folder/power/cut"
      [ ! -e "$folder/power/cut/run/run.db" ] || begun=$((begun + 1))
      train_or_resume "$folder/power/cut/run" 2>"$folder/power/errors" ||
        fail "the power was lost after change $at (seed $seed): $(cat "$folder/power/errors")"
      is_same_run "$folder/power/cut/run" "$folder/power/calm" ||
        fail "the power was lost after change $at (seed $seed): another run"
      count=$((count + 1))
    done
  done
  [ "$begun" -gt 0 ] || fail "no run has outlived the power"
  echo "the power lost $count times, after any of $total changes on the disk, with all that was not synced" \
    "gone, or any half of it: every run went on as the one that was left alone, $begun from what it had"
}

# A disk that is full, read-only or fails once, from any change on, and then is well again.
part_disk() {
  local kind at last count=0 ended=0 run=$folder/disk/disk/run
  rm -rf "$folder/disk"
  mkdir -p "$folder/disk/disk"
  disk_library "$folder/disk/disk.so"
  "$bin/taskc" build "$task" -o "$folder/small.so" >/dev/null
  train_or_resume "$folder/disk/calm"
  DISK_FOLDER=$folder/disk/disk DISK_LOG=$folder/disk/log LD_PRELOAD=$folder/disk/disk.so train_or_resume "$run"
  last=$("$root/tests/disk/power_cut.py" count "$folder/disk/log")
  for kind in ENOSPC EROFS EIO; do
    for ((at = 1; at <= last; at += ${STEP:-1})); do
      rm -rf "$run"
      DISK_FOLDER=$folder/disk/disk DISK_FAULT=$kind DISK_AT=$at LD_PRELOAD=$folder/disk/disk.so \
        timeout 300 "$root/tests/long.sh" --in-part train_or_resume "$run" >/dev/null 2>"$folder/disk/errors" && status=0 || status=$?
      [ "$status" -le 2 ] || fail "$kind at change $at: exit status $status: $(cat "$folder/disk/errors")"
      if [ "$status" -ne 0 ]; then
        [ -s "$folder/disk/errors" ] || fail "$kind at change $at: ended without a word"
        ended=$((ended + 1))
        train_or_resume "$run" 2>"$folder/disk/errors" ||
          fail "$kind at change $at, then all was well: $(cat "$folder/disk/errors")"
      fi
      is_same_run "$run" "$folder/disk/calm" || fail "$kind at change $at: another run"
      count=$((count + 1))
    done
  done
  [ "$ended" -gt 0 ] || fail "no fault was noticed"
  echo "$count times full (ENOSPC), read-only (EROFS) or broken once (EIO) from any of $last changes on: $ended" \
    "runs ended with a message and went on when all was well, the others did not need it; all as left alone"
}

# A trainer in $1 that trains until it is told to end; sets `server`.
serve() {
  "$bin/trainer" serve "$task" --profile fast --episodes 100000000 --out "$1" --quiet >/dev/null 2>"$1.errors" &
  server=$!
  until [ -s "$1/control.json" ]; do
    kill -0 "$server" 2>/dev/null || fail "the trainer: $(cat "$1.errors")"
    sleep 0.05
  done
}

# More clients than it takes, fast ones, slow ones and strange ones (tests/load/server_load.py).
part_load() {
  local figures
  rm -rf "$folder/load"
  mkdir -p "$folder/load"
  serve "$folder/load/run"
  figures=$("$root/tests/load/server_load.py" "$folder/load/run" --seconds "${SECONDS_OF_LOAD:-60}") ||
    { kill_tree "$server"; fail "$figures"; }
  "$bin/trainer" ctl --run "$folder/load/run" stop >/dev/null
  wait "$server" || fail "the trainer ended with status $?"
  echo "$figures"
}

# Every fuzzer of the build with sanitizers (cmake --preset fuzz), one after the other.
part_fuzz() {
  local fuzzers=${FUZZ:-$root/build-fuzz/bin} fuzzer count=0 text total=0
  rm -rf "$folder/fuzz"
  mkdir -p "$folder/fuzz"
  for fuzzer in "$fuzzers"/fuzz_*; do
    text=$(cd "$folder/fuzz" && "$fuzzer" "-max_total_time=$((${MINUTES:-60} * 60))" "-seed=${SEED:-7}" \
      2>"$folder/fuzz/errors") ||
      fail "$(basename "$fuzzer"): $(tail -n 30 "$folder/fuzz/errors"); the text is in $folder/fuzz/last-input"
    echo "  $text" >&2
    total=$((total + $(sed -n 's/.*: \([0-9]*\) texts.*/\1/p' <<<"$text")))
    count=$((count + 1))
  done
  [ "$count" -gt 0 ] || fail "no fuzzers in $fuzzers: cmake --preset fuzz && cmake --build --preset fuzz"
  echo "$count fuzzers, ${MINUTES:-60} minutes each: $total texts, nothing found"
}

part_soak() { "$root/tests/soak.sh" "$bin" "$folder/soak" "${HOURS:-8}" | tail -n 1; }

part_slurm() { "$root/tests/slurm/study.sh" "$bin" | tail -n 1; }

# How a part calls one of these functions in a process of its own.
if [ "${1:-}" = --in-part ]; then
  shift
  "$@"
  exit
fi

for part in "${parts[@]}"; do
  if [ -e "$folder/$part.done" ] && [ -z "${AGAIN:-}" ]; then
    echo "$part: $(cat "$folder/$part.done") (before)"
    continue
  fi
  started=$SECONDS
  echo "$part ..." >&2
  figures=$(set -e; "part_$part")  # not followed by ||, which would switch -e off in it
  printf '%s (%d s)\n' "$figures" $((SECONDS - started)) >"$folder/$part.done"
  echo "$part: $(cat "$folder/$part.done")"
done
