#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# shellTexts.sh man|zsh|fish: what make install puts in place beside the command,
# made from the texts of decalioc --help: a man page, completion in zsh, in fish.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
decalioc=$root/bin/decalioc

# "NAME TAB what it does", one line a command
commands () { "$decalioc" --help | sed -nE 's/^  ([a-z]+) +(.*)/\1\t\2/p'; }

# The options of a command: those of its call and of the list below.
options () {
  "$decalioc" "$1" --help | grep -E "^(decalioc $1| +--)" |
    { grep -oE -- '--[a-z][a-z-]*' || true; } | awk '!seen[$0]++'
}

# A line of text as roff has it: \ and - as they are, no request at its start.
roff () { sed 's/\\/\\e/g; s/-/\\-/g; s/^\([.'"'"']\)/\\\&\1/'; }

section () {                  # section TITLE: the text from the input, as it is
  printf '.SH %s\n.nf\n' "$1"
  roff
  echo .fi
}

man () {
  printf '.TH DECALIOC 1 "" "DEcalioc %s" "User Commands"\n' "$(< "$root/VERSION")"
  printf '.SH NAME\ndecalioc \\- %s\n' \
    'calibrates DEM models against measurements and says why they miss them'
  "$decalioc" --help | section DESCRIPTION
  commands | while IFS=$'\t' read -r name _; do
    "$decalioc" "$name" --help | section "decalioc $name"
  done
  echo "The manual is in $root/docs." | section 'SEE ALSO'
}

zsh () {
  printf '#compdef decalioc\n_decalioc () {\n  local -a commands options\n  commands=(\n'
  commands | sed "s/:/\\\\:/g; s/'/'\\\\''/g; s/^\([a-z]*\)\t\(.*\)/    '\1:\2'/"
  printf "  )\n  if (( CURRENT == 2 )); then _describe command commands; return; fi\n"
  printf '  case $words[2] in\n'
  commands | while IFS=$'\t' read -r name _; do
    printf '    %s) options=(%s) ;;\n' "$name" "$(options "$name" | paste -sd ' ')"
  done
  printf '  esac\n  if [[ $PREFIX == -* ]]; then compadd -- $options --help; else _files; fi\n'
  printf '}\n_decalioc "$@"\n'
}

fish () {
  echo 'complete -c decalioc -n __fish_use_subcommand -f'
  commands | while IFS=$'\t' read -r name what; do
    printf "complete -c decalioc -n __fish_use_subcommand -a %s -d '%s'\n" "$name" \
      "${what//\'/\\\'}"
    options "$name" | while read -r option; do
      printf "complete -c decalioc -n '__fish_seen_subcommand_from %s' -l %s\n" \
        "$name" "${option#--}"
    done
  done
  echo 'complete -c decalioc -l help'
}

case ${1:-} in
  man|zsh|fish) "$1" ;;
  *) echo "shellTexts.sh: man, zsh or fish is needed, got '${1:-}'." >&2; exit 1 ;;
esac
