#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# slurm-up.sh DIR [PID]
#
# Starts a Slurm cluster of one or more nodes on this machine, for tests: munged,
# slurmctld and slurmd, all under DIR (a short path without spaces), reachable
# through the loopback only, with a munge key and ports of their own; neither
# systemd nor cgroups are needed, but the caller has to be root.
# With PID the cluster goes down by itself when that process is gone.
#
# SLURM_TEST_NODES  number of nodes, n1 n2 ... (default 1), each a slurmd
# SLURM_TEST_CPUS   processors that a node pretends to have (default: real)
# SLURM_TEST_WAIT   seconds to wait for the node (default 60)
#
# Clients need   export SLURM_CONF=DIR/slurm.conf   ; stop: slurm-down.sh DIR
set -eu
PATH=$PATH:/usr/sbin:/sbin
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "${1:?slurm-up.sh DIR [PID]}"
dir=$(cd "$1" && pwd)
owner=${2:-}
node=$(hostname -s)
cpus=${SLURM_TEST_CPUS:-$(nproc)}
nodes=${SLURM_TEST_NODES:-1}
memory=$(awk '/MemTotal/ {print int ($2 / 1024 * 0.9)}' /proc/meminfo)

# a port of the loopback on which nobody listens
freePort () {
  local port
  while :; do
    port=$((20000 + RANDOM % 12000))
    (exec 3<> "/dev/tcp/127.0.0.1/$port") 2> /dev/null || break
  done
  echo "$port"
}

configure () {
  cat << CONF
ClusterName=decalioc
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$(freePort)
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
AuthType=auth/munge
AuthInfo=socket=$dir/run/munge.socket
CredType=cred/munge
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool/%n
SlurmctldPidFile=$dir/run/slurmctld.pid
SlurmdPidFile=$dir/run/slurmd-%n.pid
SlurmctldLogFile=$dir/log/slurmctld.log
SlurmdLogFile=$dir/log/slurmd-%n.log
# no cgroups, no accounting data base
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc=$dir/log/jobcomp.log
MpiDefault=none
SwitchType=switch/none
MailProg=/bin/true
# react within a second
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
KillWait=2
MinJobAge=300
SlurmctldTimeout=30
SlurmdTimeout=${SLURM_TEST_NODE_TIMEOUT:-20}
# more processors than the machine has are allowed
SlurmdParameters=config_overrides
ReturnToService=2
EnforcePartLimits=ALL
MaxArraySize=2001
MaxJobCount=20000
# a new state folder shall not count from 1 again
FirstJobId=$((1000 + $(date +%s) % 60000 * 1000))
# jobs of the partition urgent end those of main
PreemptType=preempt/partition_prio
PreemptMode=CANCEL
$(for ((i = 1; i <= nodes; i++)); do
  echo "NodeName=n$i NodeHostname=$node NodeAddr=127.0.0.1 Port=$(freePort)" \
    "CPUs=$cpus RealMemory=$((memory / nodes)) State=UNKNOWN"
done)
PartitionName=main Nodes=n[1-$nodes] Default=YES PriorityTier=1 State=UP
PartitionName=urgent Nodes=n[1-$nodes] PriorityTier=9 PreemptMode=OFF State=UP
CONF
}

mkdir -p "$dir"/{state,spool,log,run,munge}
for ((i = 1; i <= nodes; i++)); do mkdir -p "$dir/spool/n$i"; done
chmod 0755 "$dir" "$dir/run"
chmod 0700 "$dir/munge"
if [ ! -s "$dir/munge/munge.key" ]; then
  (umask 077; head -c 1024 /dev/urandom > "$dir/munge/munge.key")
fi
[ -s "$dir/slurm.conf" ] || configure > "$dir/slurm.conf"
# slurmd of 23.11 wants a cgroup plugin also where nothing uses one; v1 needs no mount
[ -s "$dir/cgroup.conf" ] || echo CgroupPlugin=cgroup/v1 > "$dir/cgroup.conf"
export SLURM_CONF=$dir/slurm.conf

munged --force --key-file="$dir/munge/munge.key" \
  --socket="$dir/run/munge.socket" --pid-file="$dir/run/munged.pid" \
  --log-file="$dir/log/munged.log" --seed-file="$dir/munge/munge.seed" \
  2> "$dir/log/munged.start"
slurmctld
for ((i = 1; i <= nodes; i++)); do slurmd -N "n$i"; done

if [ -n "$owner" ]; then
  # shellcheck disable=SC2016
  setsid bash -c 'while kill -0 "$1" 2> /dev/null; do sleep 3; done
    exec "$2/slurm-down.sh" "$3"' watch "$owner" "$here" "$dir" \
    < /dev/null > /dev/null 2>&1 &
fi

for ((i = 0; i < 2 * ${SLURM_TEST_WAIT:-60}; i++)); do
  state=$(sinfo -h -p main -o %T 2> /dev/null | sort -u || true)
  case $state in
    idle | mixed | allocated) exit 0 ;;
  esac
  sleep 0.5
done
echo "slurm-up.sh: not all nodes came up (state '$state')" >&2
tail -n 20 "$dir"/log/*.log >&2
exit 1
