#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# gridengine-up.sh DIR [PID]
#
# Starts a Grid Engine of one host on this machine, for tests: sge_qmaster and
# sge_execd with a root, a cell and ports of their own, all under DIR (a short
# path without spaces). The caller has to be root. With PID it goes down by
# itself when that process is gone.
#
# GRIDENGINE_TEST_SLOTS   slots that the host pretends to have (default 8)
#
# Clients need the variables that DIR/settings.sh sets; stop:
# gridengine-down.sh DIR
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "${1:?gridengine-up.sh DIR [PID]}"
dir=$(cd "$1" && pwd)
owner=${2:-}
shared=/usr/share/gridengine
programs=/usr/lib/gridengine
log=$dir/start.log

# a port of the loopback on which nobody listens
freePort () {
  local port
  while :; do
    port=$((20000 + RANDOM % 12000))
    (exec 3<> "/dev/tcp/127.0.0.1/$port") 2> /dev/null || break
  done
  echo "$port"
}

settings () {
  echo "export SGE_ROOT=$dir/root SGE_CELL=default"
  echo "export SGE_QMASTER_PORT=$(freePort) SGE_EXECD_PORT=$(freePort)"
  echo "export PATH=$programs:\$PATH"
}

# the folders and the data base, as Debian's init_cluster makes them
prepare () {
  local common=$SGE_ROOT/default/common part
  mkdir -p "$common" "$dir"/tmp "$dir"/spool/{qmaster/job_scripts,db,execd}
  for part in bin lib util utilbin; do
    ln -sfn "/var/lib/gridengine/$part" "$SGE_ROOT/$part"
  done
  sed -E "s|^(admin_user ).*|\1none|; s|/var/spool/gridengine/spooldb|$dir/spool/db|
          s|/var/spool/gridengine|$dir/spool|" "$shared/default-bootstrap" \
    > "$common/bootstrap"
  # one name for this machine, whatever it is called
  echo localhost > "$common/act_qmaster"
  echo "localhost $(hostname)" > "$common/host_aliases"
  # root's jobs are allowed, and the host reports every second
  sed -E "s|/var/spool/gridengine|$dir/spool|; s|^(min_[ug]id ).*|\1 0|
          s|^(load_report_time ).*|\1 00:00:01|" \
    "$shared/default-configuration" > "$dir/global"
  spoolinit berkeleydb libspoolb "$dir/spool/db" init
  spooldefaults configuration "$dir/global"
  spooldefaults complexes "$shared/util/resources/centry"
  spooldefaults usersets "$shared/util/resources/usersets"
  spooldefaults managers "$(id -un)"
}

# calls a program until the master answers
insist () {
  local i
  for ((i = 0; i < 60; i++)); do
    "$@" && return
    sleep 0.25
  done
  return 1
}

configure () {
  qconf -as localhost
  qconf -ah localhost || true          # may be one already
  qconf -Ap "$shared/util/resources/pe/smp"
  qconf -sq | sed -E "s|^(qname ).*|\1 main|; s|^(hostlist ).*|\1 localhost|
    s|^(pe_list ).*|\1 smp|; s|^(slots ).*|\1 ${GRIDENGINE_TEST_SLOTS:-8}|
    s|^(load_thresholds ).*|\1 NONE|; s|^(tmpdir ).*|\1 $dir/tmp|
    s|^(shell ).*|\1 /bin/bash|; s|posix_compliant|unix_behavior|" > "$dir/queue"
  qconf -Aq "$dir/queue"
  # react within a second
  qconf -ssconf | sed -E "s|^(schedule_interval ).*|\1 0:0:1|
    s/^(flush_(submit|finish)_sec ).*/\1 1/
    s|^(job_load_adjustments ).*|\1 NONE|" > "$dir/schedule"
  qconf -Msconf "$dir/schedule"
}

isUp () { qstat -f 2> /dev/null | grep -qE '^main@.* lx-[^ ]+ *$'; }

fail () {
  echo "gridengine-up.sh: Grid Engine did not come up" >&2
  tail -n 20 "$log" "$dir"/spool/qmaster/messages "$dir"/spool/execd/*/messages >&2
  exit 1
}

[ -s "$dir/settings.sh" ] || settings > "$dir/settings.sh"
# shellcheck source=/dev/null
. "$dir/settings.sh"
{
  [ -d "$SGE_ROOT" ] && isNew='' || isNew=yes
  [ -z "$isNew" ] || prepare
  "$programs/sge_qmaster"
  insist qconf -sh
  [ -z "$isNew" ] || configure
  "$programs/sge_execd"
} > "$log" 2>&1 || fail

if [ -n "$owner" ]; then
  # shellcheck disable=SC2016
  setsid bash -c 'while kill -0 "$1" 2> /dev/null; do sleep 3; done
    exec "$2/gridengine-down.sh" "$3"' watch "$owner" "$here" "$dir" \
    < /dev/null > /dev/null 2>&1 &
fi
insist isUp || fail
