#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Prints the folder to put first in PATH, so that `liggghts` is the right one:
#   LIGGGHTS unset or empty     the one that build.sh has made
#   LIGGGHTS=system             the one that is on the PATH already
#   LIGGGHTS=/path/to/program   that one, whatever its file is called
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=settings.sh
. "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

fail () { echo "path.sh: $*" >&2; exit 1; }

case ${LIGGGHTS:-} in
  '')
    folder=$(buildFolder sources) || folder=
    [ -x "$folder/bin/liggghts" ] ||
      fail "LIGGGHTS is not built yet. Run 'make liggghts', or set LIGGGHTS=/path/to/liggghts."
    echo "$folder/bin"
    exit ;;
  system)
    program=$(command -v liggghts) ||
      fail "LIGGGHTS=system, but there is no 'liggghts' on the PATH. Unset it to have one built." ;;
  *)
    program=$LIGGGHTS
    { [ -f "$program" ] && [ -x "$program" ]; } ||
      fail "LIGGGHTS=$LIGGGHTS is not a program. Give the path of the executable file, 'system', or nothing." ;;
esac

# A folder with nothing but a link: its own folder might hold another octave,
# and the run scripts call the program by the name `liggghts`.
program=$(realpath "$program")
folder=$cache/chosen-$(sha256sum <<< "$program" | cut -c 1-12)
mkdir -p "$folder"
ln -sfn "$program" "$folder/liggghts"
echo "$folder"
