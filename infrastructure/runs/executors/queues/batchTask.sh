#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# batchTask.sh BATCH GUARD TASK JOB [BEFORE]
#
# One task of a job array: looks up its run in BATCH/tasks, claims it, carries
# out BEFORE and hands over to GUARD, which carries out the run and leaves
# end.mark. TASK and JOB name the environment variables in which the queue gives
# the number of the task and that of the job.
#
# BEFORE is what Input.<executor>.before says, in base64: it goes with the job, as
# BATCH lies in a store that others may write to.
#
# A line of BATCH/tasks:  key TAB run folder
# Claiming is making the folder batch.claim: only one can. So a run that was
# submitted twice, requeued, or given up by Octave is not run (again).
#
# Exit status: 94 run claimed already, 95 no such line, 96 no such folder,
# 98 a line of BEFORE failed, otherwise that of the guard.
batch=$1 guard=$2 task=${!3:?} job=${!4:-} before=$(base64 -d <<< "${5:-}")
line=$(sed -n "${task}p" "$batch/tasks") || exit 95
IFS=$'\t' read -r _ folder <<< "$line"
[ -n "$folder" ] || exit 95
cd "$folder" || exit 96
mkdir batch.claim 2> /dev/null || exit 94
rm -f -- stdout.txt stderr.txt         # not through links in their place
set -C
echo "${job}_$task on $HOSTNAME" > batch.claim/who
exec 3> stdout.txt 4> stderr.txt
set +C
# a function, as its lines may return
prepare () { set --; eval "$before"; }
if [ -n "$before" ] && ! prepare >&3 2>&4; then
  echo "ERROR: a line of Input.<executor>.before failed" >&3
  draft=end.mark.$RANDOM$RANDOM.$RANDOM$RANDOM.tmp
  set -C
  echo '98 0.0 finished' > "$draft" && mv -T -- "$draft" end.mark
  exit 98
fi
cd "$folder" || exit 96
# A queue may kill this shell alone, and at once: the guard has a session of its
# own, and watches this process.
setsid --wait bash "$guard" "$folder" $$ &
guard=$!
trap 'kill -TERM "$guard" 2> /dev/null' TERM INT HUP
wait "$guard"
status=$?
while kill -0 "$guard" 2> /dev/null; do # a trap ends the first wait too early
  wait "$guard"
  status=$?
done
exit $status
