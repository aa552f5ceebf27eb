#!/usr/bin/env bash
# Everyday use, for hours: two trainers, of which one is never ended and the other is killed now and then. Clients
# swap tasks, set params, load and unload shadows, look at the page, the report and the events, and start a probe.
#
#   tests/soak.sh BIN FOLDER HOURS
#
# FOLDER/samples.csv gets memory, files, threads and episodes of the first trainer, twice a minute; its last line
# here says whether they stay. It fails where they do not, or where a trainer or a client does.
set -euo pipefail
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
bin=$(realpath "$1")
folder=$2
hours=$3
rm -rf "$folder"
mkdir -p "$folder"
folder=$(realpath "$folder")
task=$root/tests/runtime/trainer/tasks/leaning.task
other=$root/tests/runtime/trainer/tasks/upright.task
end=$((SECONDS + $(printf '%.0f' "$(echo "$hours * 3600" | bc -l)")))
RANDOM=${SEED:-7}

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
# A guard's child is the trainer.
trainer_of() { sed -n 's/.*"pid": \([0-9]*\).*/\1/p' "$folder/$1/control.json" 2>/dev/null; }
start() {
  "$bin/trainer" serve "${@:2}" --quiet >/dev/null 2>>"$folder/$1.errors" &
  eval "guard_$1=$!"
  local tries
  for ((tries = 0; tries < 600; ++tries)); do
    [ -z "$(trainer_of "$1")" ] || return 0
    sleep 0.1
  done
  fail "$1 did not start: $(cat "$folder/$1.errors")"
}
finish() {
  kill "$guard_calm" "$guard_killed" 2>/dev/null || true
  wait 2>/dev/null || true
}
trap finish EXIT

start calm "$task" --profile fast --episodes 100000000 --out "$folder/calm"
start killed "$task" --profile fast --episodes 100000000 --checkpoint-every 1 --out "$folder/killed"

ctl() { timeout 60 "$bin/trainer" ctl --run "$folder/$1" "${@:2}" >/dev/null 2>>"$folder/clients"; }
get() {
  local token url
  token=$(sed -n 's/.*"token": "\([^"]*\)".*/\1/p' "$folder/calm/control.json")
  url=$(sed -n 's/.*"url": "\([^"]*\)".*/\1/p' "$folder/calm/control.json")
  curl -sS --max-time 60 -o /dev/null -H "Authorization: Bearer $token" "$url$1" 2>>"$folder/clients"
}
sample() {
  local pid=$1
  echo "$SECONDS,$(awk '{ print $2 * 4 }' "/proc/$pid/statm"),$(ls "/proc/$pid/fd" | wc -l),$(
    ls "/proc/$pid/task" | wc -l)"
}

pid=$(trainer_of calm)
echo "seconds,memory [KB],files,threads" >"$folder/samples.csv"
acts=0 kills=0 probes=0 next=0
while [ $SECONDS -lt $end ]; do
  if [ $SECONDS -ge $next ]; then
    [ -d "/proc/$pid" ] || fail "the trainer ended: $(cat "$folder/calm.errors")"
    sample "$pid" >>"$folder/samples.csv"
    next=$((SECONDS + 30))
  fi
  for name in calm killed; do
    case $((RANDOM % 12)) in
      0) ctl $name swap task "$other" --now || true ;;
      1) ctl $name swap task "$task" || true ;;
      2 | 3) ctl $name set task.limit "0.$((RANDOM % 8 + 1)) s" || true ;;
      4) ctl $name load "$other" as shadow || true ;;
      5) ctl $name unload shadow || true ;;
      6) timeout 2 "$bin/trainer" ctl --run "$folder/$name" watch >/dev/null 2>&1 || true ;;
      7) get "" && get api/record ;;
      8) get report ;;
      9) "$bin/trainer" show "$folder/$name" >/dev/null ;;
      *) ctl $name status ;;
    esac || [ $name = killed ] || fail "a client of $name: $(tail -n 3 "$folder/clients")"
    acts=$((acts + 1))
  done
  if [ $((RANDOM % 40)) -eq 0 ]; then
    kill -KILL "$guard_killed"
    wait "$guard_killed" 2>/dev/null || true
    rm -f "$folder/killed/control.json"
    start killed "$folder/killed"
    kills=$((kills + 1))
  fi
  if [ $((RANDOM % 100)) -eq 0 ]; then
    rm -rf "$folder/probe"
    timeout 600 "$bin/trainer" train "$other" --profile fast --episodes 20 --runs 2 --out "$folder/probe" --quiet \
      2>>"$folder/clients" || fail "two runs beside: $(tail -n 3 "$folder/clients")"
    probes=$((probes + 1))
  fi
  sleep 0.3
done
sample "$pid" >>"$folder/samples.csv"

# Of the last quarter against the second one: the first has what is only made once.
awk -F, -v hours="$hours" -v acts=$acts -v kills=$kills -v probes=$probes '
  NR > 1 { ++n; for (i = 2; i <= 4; ++i) value[n, i] = $i }
  function most(from, to, i,   k, m) { m = 0; for (k = int(from); k <= to; ++k) if (value[k, i] > m) m = value[k, i]; return m }
  END {
    split("0,1.1,1,1", factor, ","); split("0,4096,4,1", more, ",")
    split(",memory,files,threads", name, ",")
    text = hours " hours, " acts " acts of clients, " kills " kills, " probes " studies beside:"
    for (i = 2; i <= 4; ++i) {
      before = most(n / 4 + 1, n / 2, i); after = most(3 * n / 4 + 1, n, i)
      text = text sprintf(" %s %d, then %d%s", name[i], before, after, i < 4 ? ";" : "")
      if (after > before * factor[i] + more[i]) bad = bad " " name[i]
    }
    print text
    if (bad != "") { print "grows:" bad; exit 1 }
  }' "$folder/samples.csv" || fail "what it takes grows: $folder/samples.csv"
kill "$guard_killed" 2>/dev/null && wait "$guard_killed" 2>/dev/null || true
episodes=$("$bin/trainer" show "$folder/killed" --json | sed -n 's/.*"episodes": \([0-9]*\).*/\1/p' | head -1)
"$bin/trainer" reproduce "$folder/killed" --episodes $((episodes < 50 ? episodes : 50)) --quiet ||
  fail "reproduce $folder/killed"
