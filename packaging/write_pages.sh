#!/usr/bin/env bash
# write_pages.sh TASKC TRAINER FOLDER: writes the manual pages of both programs, and what completes
# their command lines in shells.
set -euo pipefail
taskc=$1 trainer=$2
cd "$3"

rm -rf man1 bash zsh fish
mkdir man1 bash zsh fish
for program in "$taskc" "$trainer"; do
  name=$(basename "$program")
  "$program" manual man1
  "$program" completion bash >"bash/$name"
  "$program" completion zsh >"zsh/_$name"
  "$program" completion fish >"fish/$name.fish"
done
gzip -9n man1/*
