#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# endTests.sh SECONDS PID FOLDER NOTE: kills the Octave PID that runs the tests, and
# whatever has FOLDER as its TMPDIR, when these have used SECONDS of processor since
# this was started, or when 4 * SECONDS of the clock are over: then they wait for
# something. A busy machine ends nothing. NOTE gets the sentence that says so.
limit=$1 pid=$2 folder=$3 note=$4
ticks=$(getconf CLK_TCK)

tree () {           # who belongs to the tests, but for this one
  echo "$pid"
  grep -lzx "TMPDIR=$folder" /proc/[0-9]*/environ 2> /dev/null | tr -cd '0-9\n' |
    grep -vx -e "$pid" -e $$
}

used () {           # proc(5): fields 14 to 17, own time and that of ended children
  tree | while read -r one; do
    sed 's/.*) //' "/proc/$one/stat" 2> /dev/null
  done | awk -v ticks="$ticks" '{ sum += $12 + $13 + $14 + $15 } END { print int (sum / ticks) }'
}

before=$(used)
until=$((SECONDS + 4 * limit))
while kill -0 "$pid" 2> /dev/null; do
  step=$((limit < 5 ? 1 : 5))
  sleep $step
  if [ $(($(used) - before)) -ge "$limit" ]; then
    said="ended at its limit of $limit s of processor"
  elif [ "$SECONDS" -ge "$until" ]; then
    said="ended at its limit of $((4 * limit)) s of the clock"
  else
    continue
  fi
  echo "$said" > "$note"
  echo "runTests: $said" >&2
  tree | grep -vx "$pid" | while read -r one; do kill -KILL "$one" 2> /dev/null; done
  kill -KILL "$pid"
  exit
done
