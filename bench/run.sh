#!/usr/bin/env bash
# Runs all benchmarks and writes build/bench/results.md and build/bench/results.json.
#
#   bench/run.sh             all programs, about fifteen minutes
#   bench/run.sh NAME...     only these, e.g. simulation_bench
#
# On a busy machine, trust CPU times and the ratios within one benchmark.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

./setup.sh --tests

programs=("$@")
if [ ${#programs[@]} -eq 0 ]; then
  for program in build/bin/*_bench; do programs+=("$(basename "$program")"); done
fi

mkdir -p build/bench
results=()
for program in "${programs[@]}"; do
  echo "== $program"
  build/bin/"$program" --benchmark_out=build/bench/"$program".json --benchmark_out_format=json
  results+=(build/bench/"$program".json)
done

node bench/table.mjs build/bench "${results[@]}"
