# bash ask.bash PROGRAM LINE: what bash offers when the tab key is pressed behind the line, one word
# in a line. PROGRAM is in PATH, and its script is on standard input.
source /dev/stdin
read -ra COMP_WORDS <<<"$2"
[[ $2 == *' ' ]] && COMP_WORDS+=('')
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
"_$1"
printf '%s\n' "${COMPREPLY[@]}"
