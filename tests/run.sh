#!/usr/bin/env bash
# Installs what is missing, builds, runs all tests and ends with a line `N passed, N failed`.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

./setup.sh --tests || exit 1

echo "== Testing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
ctest --test-dir build --output-on-failure -j "$(nproc)" 2>&1 | tee "$log"
status=${PIPESTATUS[0]}

# "98% tests passed, 2 tests failed out of 100"
read -r failed total < <(sed -nE 's/.* ([0-9]+) tests? failed out of ([0-9]+).*/\1 \2/p' "$log")
skipped=$(grep -cE '\*\*\*(Skipped|Not Run)' "$log")
if [ -z "${total:-}" ] || [ "$total" -eq 0 ]; then
  echo "error: no test was run" >&2
  exit 1
fi
echo "$((total - failed - skipped)) passed, $failed failed$([ "$skipped" -gt 0 ] && echo ", $skipped skipped")"
exit "$status"
