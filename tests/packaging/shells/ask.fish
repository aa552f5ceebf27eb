# fish --no-config ask.fish PROGRAM LINE: the same in fish, without the descriptions.
source
complete -C $argv[2] | string replace -r '\t.*' ''
