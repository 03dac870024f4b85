#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# slurm-down.sh DIR
#
# Stops the cluster that slurm-up.sh started under DIR: first its jobs, then
# slurmd, slurmctld and munged, each by the process number in its pid file.
PATH=$PATH:/usr/sbin:/sbin
dir=$(cd "${1:?slurm-down.sh DIR}" 2> /dev/null && pwd) || exit 0
export SLURM_CONF=$dir/slurm.conf

running () { kill -0 "$1" 2> /dev/null; }

timeout 10 scancel --user="$(id -u)" 2> /dev/null
for ((i = 0; i < 20; i++)); do
  [ -z "$(timeout 5 squeue -h -o %i 2> /dev/null)" ] && break
  sleep 0.25
done
for file in "$dir"/run/slurmd-*.pid "$dir"/run/{slurmctld,munged}.pid; do
  daemon=$(basename "${file%.pid}")
  daemon=${daemon%-*}
  pid=$(cat "$file" 2> /dev/null) || continue
  # the number may belong to somebody else by now
  grep -q "$daemon" "/proc/$pid/comm" 2> /dev/null || continue
  kill "$pid" 2> /dev/null
  for ((i = 0; i < 20; i++)); do
    running "$pid" || break
    sleep 0.1
  done
  running "$pid" && kill -9 "$pid"
done
exit 0
