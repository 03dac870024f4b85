#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Takes each wing off a copy of the toolbox, and runs the tests of the core there:
# the core must work without it. Exit status 1 where one fails.
# CALL: tools/wings.sh [WING...]      (or: make wings)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# wing: its folder in infrastructure/
folder_of () {
  case $1 in
    command) echo wings/command ;;            # all of bin/decalioc
    script) echo wings/script ;;              # a model of a user's script
    page) echo report/page ;;                 # the report as a page
    queues) echo runs/executors/queues ;;     # Slurm, Grid Engine
    published) echo runs/published ;;         # of 2017, not called by the method
    otherRigs) echo diagnosis/otherRigs ;;    # tests that a case does not have
    *) echo "wings.sh: command, script, page, queues, published or otherRigs is needed, got $1." >&2
       return 1 ;;
  esac
}

# A calibration from the input to its files; the diagnosis of matrices; that of a case
# with conditions, as a user starts it, twice.
core=(infrastructure/calibration/calibrateCase.m tests/gapDoor.tst tests/conditions.tst)

[ $# -gt 0 ] || set -- command script page queues published otherRigs
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/whole"
git ls-files -z --cached --others --exclude-standard |
  tar --null --ignore-failed-read -T - -cf - 2> /dev/null | tar -C "$work/whole" -xf -
failed=0
for wing in "$@"; do
  folder=infrastructure/$(folder_of "$wing")
  [ -d "$folder" ] || { echo "wings.sh: there is no folder $folder." >&2; exit 1; }
  copy=$work/$wing
  cp -a "$work/whole" "$copy"
  rm -r "${copy:?}/$folder"
  for test in "${core[@]}"; do
    if ! said=$(cd "$copy" && CASE=. tools/octave.sh tests/runTests.m "$test" 2>&1); then
      printf '%s\n' "$said"
      failed=1
    fi
    printf 'without %-10s  %-48s %s\n' "$wing" "$test" "$(tail -1 <<< "$said")"
  done
  rm -rf "$copy"
done
exit $failed
