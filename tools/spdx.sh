#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Checks that each file of code says its licence, the one of CITATION.cff, in a line
# of its own: the last one of .m and .tst (a first line would be their help text), one
# of the first three of .sh and .py. Without it stay the forms, templates and models
# that a user copies into a case of his own, and tests/reported and tests/strangers, which
# are such cases; every byte of a model is in the key of its runs, too.
# CALL: tools/spdx.sh            exit status 1, and the files, where it is missing
#       tools/spdx.sh --add      writes it where it is missing
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
licence=$(sed -n 's/^license: *//p' CITATION.cff)
mark="SPDX-License-Identifier: $licence"
list () { git ls-files -z -- "$@"; }
git rev-parse 2> /dev/null || list () { find . -type f \( -name '*.m' -o -name '*.tst' -o -name '*.sh' -o -name '*.py' \) -print0; }

isCopied () {
  case /$1 in
    /templates/*|*/DEMmodels/*|/tests/reported/*/*|/tests/strangers/*/*) true ;;
    */loadInput.m|*/loadEffects.m|*/costFunction.m) true ;;
    *) false ;;
  esac
}

has () {          # links are looked at where they point to
  case $1 in
    *.m|*.tst) [ "$(tail -n 1 "$1")" = "% $mark" ] ;;
    *) head -n 3 "$1" | grep -qx "# $mark" ;;
  esac
}

add () {
  case $1 in
    *.m|*.tst)
      [ -z "$(tail -c 1 "$1")" ] || echo >> "$1"
      printf '\n%% %s\n' "$mark" >> "$1" ;;
    *)
      if head -n 1 "$1" | grep -q '^#!'; then
        sed -i "1a # $mark" "$1"
      else
        sed -i "1i # $mark" "$1"
      fi ;;
  esac
}

missing=0
while IFS= read -r -d '' file; do
  if [ -L "$file" ] || isCopied "${file#./}" || has "$file"; then
    continue
  elif [ "${1:-}" = --add ]; then
    add "$file"
  else
    echo "$file: the line '$mark' is missing (tools/spdx.sh --add)"
    missing=1
  fi
done < <(list '*.m' '*.tst' '*.sh' '*.py')
exit $missing
