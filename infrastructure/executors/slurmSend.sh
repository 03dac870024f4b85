#!/bin/bash
# slurmSend.sh BATCH WORD...
#
# Runs sbatch WORD... and keeps the job number in BATCH/id, so that it is known
# even if Octave is killed while sbatch is at work. What sbatch says goes to
# stdout. Variables of a job in which Octave itself may be running would be
# taken as options of the new one: they are removed.
batch=$1
shift
for name in "${!SLURM_@}"; do
  [ "$name" = SLURM_CONF ] || unset "$name"
done
sbatch --parsable "$@" 2>&1 > "$batch/id.part" < /dev/null
status=$?
[ $status = 0 ] && mv "$batch/id.part" "$batch/id"
exit $status
