#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# mainTask.sh PROGRAM COMMAND FOLDER
#
# The job of decalioc submit: carries out PROGRAM COMMAND FOLDER, bin/decalioc
# run for instance, and writes what it says to FOLDER/submitted/said.txt: a queue
# may have no log for the path. When the queue ends the job (TERM), Octave gets a
# Ctrl-C; should it leave its lock behind, that is removed, as other machines
# could not tell that it is gone.
#
# Exit status: that of the program.
program=$1 command=$2 folder=$3
exec > "$folder/submitted/said.txt" 2>&1 < /dev/null
echo "job ${SLURM_JOB_ID:-${JOB_ID:-}} on $HOSTNAME, $(date '+%Y-%m-%d %H:%M')"
set -m                        # else a child in the background has no Ctrl-C
"$program" "$command" "$folder" &
octave=$!
trap 'kill -INT "$octave" 2> /dev/null' TERM INT HUP
wait "$octave"
status=$?
while kill -0 "$octave" 2> /dev/null; do  # a trap ends the first wait too early
  wait "$octave"
  status=$?
done
{ read -r host pid _ < "$folder/decalioc.lock"; } 2> /dev/null
[ "${host-} ${pid-}" != "$HOSTNAME $octave" ] || rm -f -- "$folder/decalioc.lock"
exit "$status"
