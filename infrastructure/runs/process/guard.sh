#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# guard.sh FOLDER [WATCH]
#
# Runs ./runscript in FOLDER and writes how it ended to FOLDER/end.mark, one
# line "<exit code> <seconds> <finished|timeout|killed>", whole or not at all.
#
# The run gets a session of its own, so that everything it starts (mpirun and
# its ranks too) can be ended together: when FOLDER/limit holds a number of
# seconds and the run took longer, when the process WATCH is gone, or when this
# script is told to end. Seconds are counted on the monotonic clock: setting
# the wall clock harms nothing.
set -u

# A pipe of the Octave that started this, open here too, would hide its death
# from who reads the other end; 255 is this script.
for path in "/proc/$$/fd"/*; do
  fd=${path##*/}
  [ "$fd" -gt 2 ] && [ "$fd" -ne 255 ] && eval "exec $fd>&-"
done

cd -- "$1" || exit 97
# What this script writes is new: nothing is opened through a link that somebody
# who shares the store has put in its place.
rm -f -- stdout.txt stderr.txt pid
set -C
watch=${2:-}
read -r DECALIOC_CPU 2> /dev/null < cpu || DECALIOC_CPU=1
export DECALIOC_CPU                  # a runscript may hand it to mpirun
why=finished

# The numbers that a run writes are the same whoever starts it: not 1,5.
if [ -n "${LC_ALL:-}" ]; then
  export LANG=$LC_ALL
  unset LC_ALL LC_CTYPE LC_COLLATE LC_MESSAGES LC_MONETARY LC_TIME
fi
export LC_NUMERIC=C

# a single run needs no network: without these, OpenMPI looks for one for 0.3 s
export OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_pml=ob1
export OMPI_MCA_btl=self,vader OMPI_MCA_hwloc_base_binding_policy=none
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMP_NUM_THREADS=1

uptime_ds () {                       # tenths of a second since boot
  local up
  read -r up _ < /proc/uptime
  up=${up%?}
  echo $((10#${up/./}))
}

end_session () {
  pkill -TERM -s "$run"
  for _ in 1 2 3 4 5 6 7 8 9 10; do
    pgrep -s "$run" > /dev/null || return
    sleep 0.2
  done
  pkill -KILL -s "$run"
}

over_limit () {
  local limit
  read -r limit 2> /dev/null < limit || return 1
  (( $(uptime_ds) - start > limit * 10 ))
}

is_alive () {                        # a process that ended may still be listed
  local stat
  read -r stat 2> /dev/null < "/proc/$1/stat" || return
  stat=${stat##*) }
  [[ $stat != [ZX]* ]]
}

mark () {              # start, boot, command, PID namespace: processStart.m
  local stat name boot fields space
  read -r stat < "/proc/$$/stat"
  name=${stat#*(}
  name=${name%)*}
  read -r boot 2> /dev/null < /proc/sys/kernel/random/boot_id || boot=-
  read -r -a fields <<< "${stat##*) }"
  space=$(readlink "/proc/$$/ns/pid" 2> /dev/null)
  space=${space//[!0-9]/}
  echo "${fields[19]} $boot ${name// /_} ${space:--}"
}

watcher () {                         # waits without starting a process a second
  exec {quiet}<> <(:)
  while ! read -r -t 1 -u "$quiet"; do
    if over_limit; then
      kill -USR1 $$
    elif [ -n "$watch" ] && ! is_alive "$watch"; then
      kill -TERM $$
    else
      continue
    fi
    return
  done
}

start=$(uptime_ds)
setsid bash ./runscript > stdout.txt 2> stderr.txt < /dev/null &
run=$!
trap 'why=timeout; end_session' USR1
trap 'why=killed; end_session' TERM INT HUP
if ! echo "$$ $run $(mark)" > pid; then        # a full disk
  why=killed
  end_session
fi
watcher &
watching=$!

wait "$run"
code=$?
while kill -0 "$run" 2> /dev/null; do # a trap ends the first wait too early
  wait "$run"
  code=$?
done
kill "$watching" 2> /dev/null
pkill -KILL -s "$run"

ds=$(($(uptime_ds) - start))
draft=end.mark.$RANDOM$RANDOM.$RANDOM$RANDOM.tmp
printf '%d %d.%d %s\n' "$code" $((ds / 10)) $((ds % 10)) "$why" > "$draft" ||
  exit 98
# The mark says that the files of the run are whole, after a power cut, too.
find . -type f -size +0 \( -newer job.json -o -name job.json -o \
  -name data.head -o -name params.csv \) -exec sync -- {} + 2> /dev/null
mv -T -- "$draft" end.mark
