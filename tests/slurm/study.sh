#!/usr/bin/env bash
# A study on a real Slurm cluster of two nodes on this machine, of which one dies and the other has to
# make room, and with a disk that is full for one of the runs: what comes of it is what this machine's
# own engine comes to, bit for bit.
#
#   tests/slurm/study.sh [BIN]     BIN: the folder of trainer and taskc; build/bin by default
#
# Needs root, and Debian's slurmctld, slurmd, slurm-client and munge; ends with 77 where it cannot run.
# Takes some minutes: Slurm waits before it believes that a node is dead.
set -euo pipefail
bin=$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../../build/bin}")
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
cannot() {
  echo "skipped: $*" >&2
  exit 77
}
for program in slurmctld slurmd sbatch munged; do
  command -v "$program" >/dev/null ||
    cannot "$program is missing: apt-get install slurmctld slurmd slurm-client munge"
done
[ "$(id -u)" -eq 0 ] || cannot "slurmd needs root"

folder=$(mktemp -d)
mount -t tmpfs none "$folder" 2>/dev/null || {
  rmdir "$folder"
  cannot "this system lets nobody mount a disk"
}
umount "$folder"
cluster=$folder/cluster
mkdir "$cluster"
chmod 0755 "$folder"
source "$here/cluster.sh"
# shellcheck source=tests/run_record.sh
source "$here/../run_record.sh"
small_disk=
finish() {
  local status=$?
  stop_cluster
  [ -z "$small_disk" ] || umount "$small_disk"
  if [ $status -eq 0 ]; then rm -rf "$folder"; else echo "left behind: $folder" >&2; fi
  exit $status
}
trap finish EXIT

cat >"$folder/study.toml" <<END
episodes = ${EPISODES:-60}
profile = "fast-tree"

[[experiments]]
name = "crawling"
task = "$here/../../tasks/crawling.task"
seeds = "1..6"

[[experiments]]
name = "ppo"
task = "$here/../../tasks/jumping.task"
agent = "ppo"
seeds = "1..6"

[slurm]
partition = "low"
memory = "100M"
END

status_of() { "$bin/trainer" study status "$folder/slurm" --json; }
count() { status_of | grep -c "\"state\": \"$1\"" || true; }
episodes() { status_of | awk -F '[:,]' '/"episodes":/ { sum += $2 } END { print sum + 0 }'; }
running_on() { squeue -h -r -p low -w "$1" -t RUNNING | wc -l; }
# Slurm holds back for two minutes what was requeued.
hurry() {
  local task
  for task in $(squeue -h -r -t PENDING -o %i); do
    scontrol update jobid="$task" starttime=now 2>/dev/null || true
  done
}

echo "== This machine's engine"
"$bin/trainer" study "$folder/study.toml" --out "$folder/local" --quiet

# A run's folder on a disk of its own, with room for little more than what it has.
put_on_small_disk() {
  local kilobytes
  kilobytes=$(du -s --apparent-size "$1" | cut -f1)
  mv "$1" "$1.moved"
  mkdir "$1"
  mount -t tmpfs -o "size=$((kilobytes + 400))k" none "$1"
  small_disk=$1
  cp -a "$1.moved/." "$1"
  rm -r "$1.moved"
}

echo "== A cluster of two nodes, and a disk that will be full"
start_cluster
scontrol update partitionname=low state=down  # nothing starts yet
"$bin/trainer" study "$folder/study.toml" --engine slurm --out "$folder/slurm"
put_on_small_disk "$folder/slurm/crawling/seed1"
scontrol update partitionname=low state=up
# All trainers stand still while this script looks: none is over before what is to befall it.
until [ "$(running_on n1)" -gt 0 ] && [ "$(running_on n2)" -gt 0 ] && [ "$(episodes)" -ge "${BEFORE_KILL:-60}" ]; do
  squeue -h -r | grep -q . || { echo "error: the runs ended too early; try more EPISODES" >&2; exit 1; }
  signal_trainers CONT n1 n2
  sleep 0.3
  signal_trainers STOP n1 n2
done

echo "== n1 dies with $(running_on n1) runs"
kill_node n1
"$bin/trainer" report "$folder/slurm" -o "$folder/report.html" >/dev/null
echo "   a report of the runs as they are: $(stat -c %s "$folder/report.html") bytes"
echo "== n2 makes room for another job, from $(running_on n2) runs"
sbatch --parsable -p high -w n2 --exclusive --output=/dev/null --wrap 'sleep 2' >/dev/null
while [ "$(running_on n2)" -gt 0 ]; do sleep 0.2; done
signal_trainers CONT n2  # that they hear it
scontrol update nodename=n1 state=down reason=died
start_node n1
sleep 5  # until it has heard the end of what died with it, which would end what begins there
scontrol update nodename=n1 state=resume
# Called again, it submits nothing that is in the queue.
"$bin/trainer" study "$folder/study.toml" --engine slurm --out "$folder/slurm"

# Until so many are finished, and nothing is left in the queue. A task that Slurm has ended for good, as
# that of a node that is back too soon, is submitted again as a user would do it.
wait_for_finished() {
  local started=$SECONDS again=0
  until [ "$(count finished)" -eq "$1" ] && ! squeue -h -r -p low | grep -q .; do
    hurry
    sleep 1
    if [ $again -lt 3 ] && ! squeue -h -r -p low | grep -q . && [ "$(count finished)" -lt "$1" ]; then
      again=$((again + 1))
      echo "== The study is submitted again: Slurm has ended tasks of it"
      "$bin/trainer" study "$folder/study.toml" --engine slurm --out "$folder/slurm"
    fi
    if [ $((SECONDS - started)) -gt "${PATIENCE:-250}" ]; then
      echo "error: $1 runs were not finished in time" >&2
      status_of >&2
      squeue -r >&2
      tail -n 5 "$folder"/slurm/slurm/*.out >&2
      exit 1
    fi
  done
}
wait_for_finished 11
grep -h 'disk' "$folder"/slurm/slurm/*.out | sort -u | sed 's/^/   /' ||
  { echo "error: no task says that its disk is full" >&2; exit 1; }
echo "== The disk has room again, and the study is submitted again"
mount -o remount,size=64m "$small_disk"
"$bin/trainer" study "$folder/study.toml" --engine slurm --out "$folder/slurm"
wait_for_finished 12
"$bin/trainer" study status "$folder/slurm"
requeued=$(grep -c 'requeue' "$cluster/slurmctld.log" || true)

differing=0
for run in "$folder"/local/*/seed*; do
  other=$folder/slurm/${run#"$folder/local/"}
  if ! is_same_run "$run" "$other"; then
    echo "differs: ${run#"$folder/local/"}"
    differing=$((differing + 1))
  fi
done
echo "12 runs, $requeued notes of requeued tasks, $differing differ"
[ "$differing" -eq 0 ] && [ "$requeued" -gt 0 ]
