# zsh -f ask.zsh PROGRAM LINE: the same in an interactive zsh on a terminal of its own.
zmodload zsh/zpty
folder=$(mktemp -d)
trap "rm -rf ${(q)folder}" EXIT
cat >$folder/_$1
cat >$folder/setup <<'SETUP'
PROMPT='' PS2='' RPROMPT=''
autoload -Uz compinit
compinit -D -u
# All that is offered goes through compadd. What is only counted or sorted out is not offered yet.
compadd() {
  if (( ${@[(I)-[OAD]*]} )); then builtin compadd "$@"; return; fi
  local -a offered
  builtin compadd -A offered "$@"
  print -rl -- offered:$^offered
  builtin compadd "$@"
}
answer() {
  _main_complete
  print answered
  compstate[insert]='' compstate[list]=''
}
zle -C answer complete-word answer
bindkey '^I' answer
stty -echo -onlcr
print ready
SETUP
zpty shell zsh -f -i
zpty -w shell "fpath=(${(q)folder} \$fpath); source ${(q)folder}/setup"
zpty -r shell answer $'*ready\n*'
zpty -w -n shell "$2"$'\t'
zpty -r shell answer $'*answered*'
zpty -d shell
print -r -- "$answer" | sed -n 's/\r//g; s/.*offered://p' | sort -u
