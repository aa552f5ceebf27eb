#!/usr/bin/env bash
# From a fresh machine to a robot that has learned something: installs, builds, compiles the six
# tasks, trains one of them for two or three minutes and writes a report with its curve and a replay.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

task=tasks/forward_rolling.task
run=runs/quickstart

./setup.sh

echo "== Compiling the tasks"
mkdir -p build/tasks
for file in tasks/*.task; do
  build/bin/taskc build "$file" -o "build/tasks/$(basename "$file" .task).so"
done

if [ -f "$run/run.db" ]; then
  echo "== Continuing the training in $run"
  build/bin/trainer resume "$run"
else
  echo "== Training: $task"
  build/bin/trainer train "$task" --agent motion_search --profile fast-tree --episodes 1200 --seed 1 --out "$run"
fi

echo "== Writing the report"
build/bin/trainer report "$run"
echo
echo "Open $run/report.html in a browser: the learning curve, and a replay of the best episode."
