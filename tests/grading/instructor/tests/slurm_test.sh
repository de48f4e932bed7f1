#!/usr/bin/env bash
# Grades a class by a Slurm of its own, whose daemons are killed half way through.
#
#   slurm_test.sh GRADE
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../../../words.sh
source "$(dirname "$(realpath "$0")")/../../../words.sh"
grade=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
header=$(realpath "$here/../../../..")/lessons/12_schlick/schlick.hpp
PATH=$PATH:/usr/sbin
for tool in slurmctld slurmd sbatch squeue munged; do
  command -v $tool >/dev/null || skip "$tool is not installed"
done
"$grade" doctor >/dev/null || skip "hidden cases are not run on this machine"
scratch=$(mktemp -d)
declare -A pids=()
end() {
  scancel --user="$(id -un)" --quiet 2>/dev/null || true
  kill -9 "${pids[@]}" 2>/dev/null || true
  rm -rf "$scratch"
}
trap end EXIT
chmod 755 "$scratch"
cd "$scratch"
export SLURM_CONF=$scratch/slurm.conf

# ---- a cluster of this machine -------------------------------------------------------------------

# On loopback alone; what an installation by systemd would bring is left out. Without DefMemPerCPU
# every task would take the whole memory; ports that nobody else has let tests run beside others.
write_configuration() {
  local port=$((20000 + $$ % 20000 * 2)) host memory
  host=$(hostname -s)
  memory=$(($(sed -n 's/^MemTotal: *\([0-9]*\) kB/\1/p' /proc/meminfo) / 1100)) # MB, nearly all
  cat >slurm.conf <<END
ClusterName=glint
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$scratch/munge.socket
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
SlurmctldLogFile=$scratch/slurmctld.log
SlurmdLogFile=$scratch/slurmd.log
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
DefMemPerCPU=100
ReturnToService=2
SlurmdTimeout=20
SchedulerParameters=batch_sched_delay=0,sched_min_interval=50000
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=$memory State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
}

start() { # NAME COMMAND...
  local name=$1
  shift
  "$@" >"$name.out" 2>&1 &
  pids[$name]=$!
  disown # so that bash says nothing of its end
}
start_slurmctld() { start slurmctld slurmctld -D; }
start_slurmd() { start slurmd slurmd -D -N "$(hostname -s)"; }

start_munge() {
  (umask 077 && head -c 1024 /dev/urandom >munge.key)
  start munged munged --foreground --socket "$scratch/munge.socket" \
    --key-file "$scratch/munge.key" --log-file "$scratch/munge.log" \
    --pid-file "$scratch/munge.pid" --seed-file "$scratch/munge.seed"
  wait_for "munged does not start" test -S munge.socket
}

# wait_for WHAT COMMAND...
wait_for() {
  local what=$1 deadline=$((SECONDS + 30))
  shift
  until "$@" >/dev/null 2>&1; do
    ((SECONDS < deadline)) || wrong "$what: $(tail -n 3 ./*.out ./*.log err 2>/dev/null)"
    sleep 0.1
  done
}
node_is_idle() { [[ $(sinfo --noheader --format=%T) == idle ]]; }

# ---- a class -------------------------------------------------------------------------------------

hand_in() { # STUDENT: the header on standard input
  mkdir -p "in/$1"
  cat >"in/$1/schlick.hpp"
}
hand_in ada <"$header"
sed 's/F0 + /F0 - /' "$header" | hand_in bob
{ echo '[[gnu::constructor]] static void f() { __builtin_trap(); }' && cat "$header"; } |
  hand_in eve
echo 'no header' | hand_in "o'neil"
sed 's/1\.0F/2.0F/' "$header" | hand_in sam
head -c 32 /dev/urandom >secret
echo zoe >roster

# grade_into OUT OPTION...
grade_into() {
  "$grade" class in --out "$@" --lesson 12 --secret secret --assignment a --roster roster
}

# without_seconds OUT: its grades, but for how long they took.
without_seconds() { rev "$1/grades.csv" | cut -d, -f1-3,5- | rev; }

# ---- tests ---------------------------------------------------------------------------------------

write_configuration
mkdir state spool
start_munge
start_slurmctld
start_slurmd
wait_for "the node does not come up" node_is_idle

grade_into slurm --slurm --chunk 2 2>err &
class=$!
wait_for "no grade comes" compgen -G 'slurm/*/report.json'
[[ $(squeue --noheader) ]] || wrong "no task is left to be disturbed"
kill -9 "${pids[slurmd]}" "${pids[slurmctld]}"
[[ ! -e slurm/grades.csv ]] || wrong "the class was graded before anything was killed"
sleep 1
start_slurmctld
start_slurmd
grade_into local --jobs 2 2>/dev/null
wait "$class" || wrong "the class ends with $?: $(<err)"
diff <(without_seconds local) <(without_seconds slurm) || wrong "other grades than here"
[[ $(wc -l <slurm/grades.csv) == 7 ]] || wrong "not everyone has a grade"
[[ ! $(squeue --noheader) ]] || wrong "tasks are left"
