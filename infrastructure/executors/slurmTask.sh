#!/bin/bash
# slurmTask.sh BATCH GUARD
#
# One task of a job array: looks up its run in BATCH/tasks, claims it and hands
# over to the guard, which carries out the run and leaves end.mark.
#
# A line of BATCH/tasks:  key TAB run folder
# Claiming is making the folder slurm.claim: only one can. So a run that was
# submitted twice, requeued, or given up by Octave is not run (again).
#
# Exit status: 94 run claimed already, 95 no such line, 96 no such folder,
# otherwise that of the guard.
line=$(sed -n "${SLURM_ARRAY_TASK_ID:?}p" "$1/tasks") || exit 95
IFS=$'\t' read -r _ folder <<< "$line"
[ -n "$folder" ] || exit 95
cd "$folder" || exit 96
mkdir slurm.claim 2> /dev/null || exit 94
echo "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID on ${SLURMD_NODENAME:-?}" \
  > slurm.claim/who
exec bash "$2" "$folder"
