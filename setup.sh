#!/usr/bin/env bash
# Installs what a Debian 12 machine lacks, and builds into build/.
#
#   ./setup.sh            the programs and what they need
#   ./setup.sh --tests    the tests and benchmarks as well
#
# Can be run any number of times; needs no network once everything is installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

programs=(
  g++ cmake ninja-build pkg-config ca-certificates # the build, and what taskc itself calls
  antlr4 libantlr4-runtime-dev                     # the parser of the task language
  libode-dev libeigen3-dev                         # the simulation and the learner
  libqhull-dev                                     # links of convex shape
  libfmt-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libmd-dev
  libsqlite3-dev libzstd-dev                       # the runs' records
  libprotobuf-dev protobuf-compiler zlib1g-dev     # what other programs read of them
  libboost-dev                                     # Beast: talking to a running trainer
  gnuplot-nox                                      # curves in documents
  libnlopt-cxx-dev                                 # fitting weights to preferences
  libpng-dev libgif-dev libvpx-dev libopenh264-dev # pictures and films of robots
  libmujoco-dev                                    # URDF and MJCF files; a second engine
  libgtest-dev libgmock-dev libbenchmark-dev
)
# A real browser, a real debugger, the format check, real shells, manual pages and a real cluster; for
# the Python package, which the programs do without.
tests=(chromium procps gdb clang-format zsh fish man-db python3-numpy slurmctld slurmd slurm-client munge)

wanted=("${programs[@]}")
# Any Node.js that is already installed is good enough for the report's page.
if ! command -v npm >/dev/null; then wanted+=(nodejs npm); fi
target=programs
if [ "${1:-}" = --tests ]; then
  wanted+=("${tests[@]}")
  target=all
fi

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

missing=()
for package in "${wanted[@]}"; do is_installed "$package" || missing+=("$package"); done

if [ ${#missing[@]} -gt 0 ]; then
  echo "== Installing ${missing[*]}"
  as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "error: these packages are missing, and installing them needs root or sudo" >&2
      exit 1
    }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" |
    awk '/^Setting up/ { printf "\r   %d packages set up", ++n; fflush() } END { if (n) print "" }'
fi

echo "== Building into build/"
cmake --preset release >/dev/null  # every time, so that what was just installed is found
cmake --build --preset release --target "$target"
