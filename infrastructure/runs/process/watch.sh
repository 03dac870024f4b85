#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# watch.sh PID START LIMIT FILE
#
# After LIMIT seconds makes FILE and kills the process PID, if it is still the
# one that began at START (field 22 of /proc/PID/stat) and has not ended.
set -u

# A pipe of PID that stayed open here would hide its death from who reads it;
# 255 is this script.
for path in "/proc/$$/fd"/*; do
  fd=${path##*/}
  [ "$fd" -gt 2 ] && [ "$fd" -ne 255 ] && eval "exec $fd>&-"
done

sleep "$3"
read -r stat 2> /dev/null < "/proc/$1/stat" || exit
read -r state _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ start _ <<< "${stat##*) }"
[[ $state != [ZX] && $start = "$2" ]] || exit
rm -f -- "$4"          # not through a link in its place
set -C
: > "$4"
kill -KILL "$1"
