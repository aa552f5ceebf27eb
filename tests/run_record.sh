# For scripts that source it, with $bin and $folder.

# All that a run's record says but the times that it took; fails where it cannot be read.
record() {
  rm -f "$folder/record.csv"
  "$bin/trainer" export "$1" --csv "$folder/record.csv" >/dev/null || return 1
  # The columns are told by their names, whatever else stands there.
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) keep[i] = $i !~ /wall|cpu/ }
           { for (i = 1; i <= NF; ++i) if (keep[i]) printf "%s,", $i; print "" }' "$folder/record.csv"
}
is_same_run() {
  local one other
  one=$(record "$1") && other=$(record "$2") && [ -n "$one" ] && [ "$one" = "$other" ]
}
