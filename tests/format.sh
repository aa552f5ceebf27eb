#!/usr/bin/env bash
# Whether all C and C++ code is laid out as .clang-format says.
#
#   tests/format.sh          lists what is not, and fails
#   tests/format.sh --fix    lays it out
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

program=$(command -v clang-format-14 || command -v clang-format || true)
# Other versions lay out some lines differently.
if [ -z "$program" ] || ! "$program" --version | grep -q 'version 14\.'; then
  echo "error: clang-format 14 is missing; ./setup.sh --tests installs it" >&2
  exit 1
fi

case ${1:-} in
  '') action=(--dry-run --Werror) ;;
  --fix) action=(-i) ;;
  *) echo "error: expected nothing or --fix" >&2; exit 2 ;;
esac

find base bench compiler fuzz libtaskc libtaskc_sim plugins runtime tests -name '*.[ch]' -o -name '*.cpp' |
  xargs -P "$(nproc)" -n 100 "$program" "${action[@]}" || {
  echo "error: some files are not laid out as .clang-format says; tests/format.sh --fix mends them" >&2
  exit 1
}
