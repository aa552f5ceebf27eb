# A Slurm cluster of two nodes on this machine's loopback, for a script that sources this file: a real
# munged, slurmctld and two slurmd, all in the folder $cluster, which nothing else uses. Needs root
# and Debian's slurmctld, slurmd, slurm-client and munge.
#
#   cluster=$(mktemp -d); start_cluster; ...; stop_cluster

export SLURM_CONF=$cluster/slurm.conf
cluster_pids=()

start_munge() {
  mkdir -p "$cluster/munge"
  chmod 0755 "$cluster" "$cluster/munge"
  dd if=/dev/urandom of="$cluster/munge/key" bs=128 count=1 status=none
  chmod 0400 "$cluster/munge/key"
  chown -R munge: "$cluster/munge"
  setpriv --reuid munge --regid munge --clear-groups munged --foreground \
    --key-file "$cluster/munge/key" --socket "$cluster/munge/socket" \
    --pid-file "$cluster/munge/pid" --log-file "$cluster/munge/log" --seed-file "$cluster/munge/seed" \
    >"$cluster/munge.out" 2>&1 &
  cluster_pids+=($!)
}

write_config() {
  mkdir -p "$cluster/state"
  cat >"$SLURM_CONF" <<END
ClusterName=test
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=$((port))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$cluster/munge/socket
CredType=cred/munge
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool-%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd-%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
JobRequeue=1
ReturnToService=1
SlurmdTimeout=20
KillWait=5
InactiveLimit=0
SlurmdParameters=config_overrides
MpiDefault=none
JobCompType=jobcomp/none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName=n1 NodeHostname=$(hostname) NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=4 RealMemory=1000
NodeName=n2 NodeHostname=$(hostname) NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=4 RealMemory=1000
PartitionName=low Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP PriorityTier=1 PreemptMode=REQUEUE
PartitionName=high Nodes=n1,n2 MaxTime=INFINITE State=UP PriorityTier=10 PreemptMode=OFF
END
  printf '%b\n' 'CgroupPlugin=cgroup/v1\nCgroupAutomount=no' >"$cluster/cgroup.conf"
}

# node: n1 or n2. Each in a session of its own, so that all of a node can be killed.
start_node() {
  mkdir -p "$cluster/spool-$1"
  setsid slurmd -D -N "$1" -f "$SLURM_CONF" >>"$cluster/slurmd-$1.out" 2>&1 &
  cluster_pids+=($!)
  eval "node_$1=$!"
}

# As if its power had gone: the daemon, and all that runs on it, also what is only just starting.
kill_node() {
  local daemon pid looks
  eval "daemon=\$node_$1"
  kill -KILL "$daemon" 2>/dev/null || true
  for looks in 1 2 3; do
    for pid in $(tasks_on "$1"); do kill -KILL "$pid" 2>/dev/null || true; done
    sleep 0.5
  done
}

# signal, nodes: to the trainers that run there.
signal_trainers() {
  local node pid
  for node in "${@:2}"; do
    for pid in $(tasks_on "$node"); do
      if [ "$(cat "/proc/$pid/comm" 2>/dev/null)" = trainer ]; then kill "-$1" "$pid" 2>/dev/null || true; fi
    done
  done
}

# All processes of a node's jobs: they carry its name, and this cluster's, in their environment.
tasks_on() {
  local file
  for file in $(grep -lz "^SLURMD_NODENAME=$1\$" /proc/[0-9]*/environ 2>/dev/null); do
    grep -qz "^SLURM_CONF=$SLURM_CONF\$" "$file" 2>/dev/null || continue
    local pid parent
    pid=$(basename "$(dirname "$file")")
    parent=$(ps -o ppid= -p "$pid" | tr -d ' ')
    ps -o args= -p "${parent:-1}" 2>/dev/null | grep -q '^slurmstepd' && echo "$parent"
    echo "$pid"
  done
  true
}

wait_for_nodes() {
  local tries
  for tries in $(seq 30); do
    [ "$(sinfo -h -N -p low -o %T 2>/dev/null | grep -cE '^(idle|mixed|allocated)$')" -ge 2 ] && return
    sleep 1
  done
  echo "error: the nodes did not come up" >&2
  tail -n 20 "$cluster"/*.log >&2
  return 1
}

start_cluster() {
  port=${SLURM_TEST_PORT:-26800}
  write_config
  start_munge
  sleep 1
  slurmctld -D -c -f "$SLURM_CONF" >"$cluster/slurmctld.out" 2>&1 &
  cluster_pids+=($!)
  sleep 1
  start_node n1
  start_node n2
  wait_for_nodes
}

stop_cluster() {
  scancel --user "$(id -un)" 2>/dev/null || true
  local pid
  for node in n1 n2; do for pid in $(tasks_on $node); do kill -KILL "$pid" 2>/dev/null || true; done; done
  for pid in "${cluster_pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
}
