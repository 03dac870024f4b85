#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Counts the words of the manual, page by page, in its two halves as docs/README.md
# lists them; exit status 1 where it has grown beyond what was asked for: 9,000 in
# the user guide, 19,000 in all.
# CALL: tools/words.sh
# A word holds a letter: numbers and bars of tables are none. Not counted are blocks to
# type in or to compare with, tables that `make figures` writes, the two indexes
# (functions.md, which `make index` makes of help texts, and identifiers.md), and the
# pages for those who change the code.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

wordsOf () { sed '/^ *```/,/^ *```/d;/^<!-- figures: /,/^<!-- end of figures/d' "$1" | tr -s '[:space:]' '\n' | grep -c '[[:alpha:]]'; }

pagesOf () {     # below the heading of docs/README.md that begins with this text
  sed -n "/^## $1/,/^## /{/^## $1/p;/^## /!p}" docs/README.md |
    grep -oE '\([a-z-]+\.md\)' | tr -d '()' | sed 's|^|docs/|' | grep -vE '(functions|identifiers).md'
}

half () {        # its name, pages
  local page n sum=0
  for page in "${@:2}"; do
    n=$(wordsOf "$page")
    printf '%7d  %s\n' "$n" "$page"
    sum=$((sum + n))
  done
  printf '%7d  %s\n' "$sum" "$1"
  total=$((total + sum))
}

total=0
mapfile -t guide < <(pagesOf 'User guide')
mapfile -t other < <(pagesOf 'Reference')
half 'User guide' README.md docs/README.md "${guide[@]}"
inGuide=$total
half 'Reference, for reviewers too' "${other[@]}"
printf '%7d  in all\n' "$total"
[ "$inGuide" -le 9000 ] && [ "$total" -le 19000 ]
