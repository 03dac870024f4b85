#!/bin/bash
# endTests.sh SECONDS PID FOLDER: kills the Octave PID that runs the tests, if it
# is still there after SECONDS, and whatever has FOLDER as its TMPDIR.
sleep "$1"
echo "runTests: no end after $1 s, killed" >&2
grep -lzx "TMPDIR=$3" /proc/[0-9]*/environ 2> /dev/null | while read -r file; do
  one=${file//[!0-9]/}
  [ "$one" = "$2" ] || [ "$one" = $$ ] || kill -KILL "$one" 2> /dev/null
done
kill -KILL "$2"
