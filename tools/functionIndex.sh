#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Writes docs/functions.md: the functions that a user may call, each with the
# first line of its help; and the lists of fields of docs/inputs.md (inputLines.m).
# CALL: tools/functionIndex.sh          (or: make index)
#       tools/functionIndex.sh --check  writes nothing; exit status 1 if it is old
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=docs/functions.md

table () {
  printf '\n| function | does |\n|---|---|\n'
  for file in "$@"; do
    name=$(basename "$file" .m)
    # shellcheck disable=SC2016
    printf '| [`%s`](../%s) | %s |\n' "$name" "$file" \
      "$(sed -nE '/^% [A-Z0-9_]+  /{s/^% [A-Z0-9_]+  //p;q}' "$file")"
  done
}

# Beside each how many %! blocks its file has.
tested () {
  printf '\n| function | does | tests |\n|---|---|---|\n'
  table "$@" | sed 1,3d | while read -r line; do
    file=$(sed -E 's/^[^(]*\(\.\.\/([^)]*)\).*/\1/' <<< "$line")
    echo "$line $(grep -cE '^%!(test|assert|error)' "$file") |"
  done
}

# The functions of folders that a text calls, or whose help it names.
named () {
  sed -E 's/^ *%.*//' | grep -oE '\b[a-z][A-Za-z]+ \(|help [a-z][A-Za-z]+' |
    sed -E 's/help |[ (]//g' | sort -u |
    while read -r name; do find infrastructure/*/ -name "$name.m"; done | sort
}

readers () {
  { sed -n '/^### Reading particle dumps/,/^### Rules/p' docs/extend.md
    find DEMmodels examples templates -path '*/OctaveFuns/*.m' ! -path '*/optim/*' \
      -exec cat {} +; } | named
}

others () { cat CONTRIBUTING.md docs/{extend,effects,gap,inputs}.md | named; }

index () {
  echo '# Functions

The functions that are meant to be called by hand or by files of your own. `help NAME` describes
each; this page is made of the first lines of their help (`make index`). Not listed: the candidate
effects of the library ([effects.md](effects.md)).

## Main scripts, and forms to fill in'
  table DEcalioc.m diagnoseGap.m loadInput.m loadEffects.m costFunction.m
  echo '
## The published functions

`test NAME` at the prompt carries out the tests of a file (their number: last column); some need
`addpath /path/to/DEcalioc/tests`.
`tests/publishedCase.tst` calls the functions of a run with the published arguments alone, in the
folder of a case, and a case in the published form, with its `loadInput`, `costFunction` and
`getResults`.'
  tested infrastructure/*.m infrastructure/runs/published/*.m \
    infrastructure/case/{assignParams,getMinMaxRayleigh,getRayleigh}.m \
    infrastructure/calibration/userInt.m infrastructure/runs/get{LastFoldersNumber,OptimFolder}.m
  echo '
## For `getResults` of a model

[Reading particle dumps](extend.md#reading-particle-dumps).'
  mapfile -t files < <(readers)
  table "${files[@]}"
  echo '
## For executors, effects and the diagnosis of matrices

[CONTRIBUTING.md](../CONTRIBUTING.md#an-executor), [gap.md](gap.md#on-matrices-for-other-dem-codes).'
  mapfile -t files < <(comm -23 <(others) <(readers))
  table "${files[@]}"
}

if [ "${1:-}" = --check ]; then
  index | diff "$page" - && exit
  echo "functionIndex.sh: $page is old. Make it again: make index" >&2
  exit 1
fi
index > "$page.part"
mv "$page.part" "$page"
"${OCTAVE:-octave-cli}" --no-gui --norc --quiet --eval "addpath infrastructure tools; startToolbox (pwd ());
  writeAtomic ('docs/inputs.md', inputLines (fileread ('docs/inputs.md')));"
