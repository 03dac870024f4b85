#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# gridengine-down.sh DIR
#
# Stops the Grid Engine that gridengine-up.sh started under DIR: first its jobs,
# then sge_execd and sge_qmaster, each by the process number in its pid file.
dir=$(cd "${1:?gridengine-down.sh DIR}" 2> /dev/null && pwd) || exit 0
# shellcheck source=/dev/null
. "$dir/settings.sh"
timeout 10 qdel -u "$(id -un)" > /dev/null 2>&1
for ((i = 0; i < 20; i++)); do
  [ -z "$(timeout 5 qstat 2> /dev/null)" ] && break
  sleep 0.25
done
for file in "$dir"/spool/execd/*/execd.pid "$dir"/spool/qmaster/qmaster.pid; do
  pid=$(cat "$file" 2> /dev/null) || continue
  # the number may belong to somebody else by now
  grep -q sge_ "/proc/$pid/comm" 2> /dev/null || continue
  kill "$pid" 2> /dev/null
  for ((i = 0; i < 50; i++)); do
    grep -q . "/proc/$pid/cmdline" 2> /dev/null || break
    sleep 0.1
  done
  kill -9 "$pid" 2> /dev/null
done
exit 0
