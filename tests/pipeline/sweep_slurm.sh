#!/usr/bin/env bash
# scripts/sweep --engine slurm with a slurmctld and slurmd started by this test.   sweep_slurm.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
sweep=$here/../../scripts/sweep
PATH=$PATH:/usr/sbin
for program in slurmctld slurmd sbatch squeue; do
    if [ -z "$(type -P $program)" ]; then
        echo "skipped: $program (packages slurmctld slurmd slurm-client) is not installed"
        claim "the program is missing" [ ! -x "$(type -P $program)" ]
        exit 0
    fi
done

# One node on this machine without authentication (munge). The ports depend on the process id, so that parallel tests do not collide.
host=$(hostname -s)
port=$((20000 + $$ % 20000))
mkdir slurm slurm/state slurm/spool
cat >slurm/slurm.conf <<END
ClusterName=sweep
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/none
CredType=cred/none
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$PWD/slurm/state
SlurmdSpoolDir=$PWD/slurm/spool
SlurmctldPidFile=$PWD/slurm/slurmctld.pid
SlurmdPidFile=$PWD/slurm/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$PWD/slurm/slurm.conf
slurmctld -D -c >slurm/slurmctld.log 2>&1 &
controller=$!
slurmd -D -N "$host" >slurm/slurmd.log 2>&1 &
node=$!
trap 'code=$?; kill "$node" "$controller" 2>/dev/null; wait "$node" "$controller" 2>/dev/null; (exit "$code"); finish' EXIT
for _ in {1..120}; do
    if sinfo --noheader --format %t 2>/dev/null | grep -q idle; then break; fi
    sleep 0.5
done
claim "the cluster has one node" [ "$(sinfo --noheader --format %t 2>/dev/null)" = idle ]

cat >rods.yaml <<'END'
design: designs/rod.yaml
vary: {geometry.width: [8 mm, 10 mm, 12 mm, 200 kPa]}
set: {mesh.size: 20 mm}
END
refuses 65 "sweep: rods.yaml:2:45: geometry.width: '200 kPa' is a pressure*" "$sweep rods.yaml --engine slurm"
sed -i 's/, 200 kPa//' rods.yaml
export SWEEP_POLL=1
runs "$sweep rods.yaml --engine slurm --folder cluster -- --comment sweep"
claim "a job array is submitted" grep -q '^sweep: submitted as job [0-9]*$' "$seen/err"
claim "progress is reported" grep -q '^sweep: 3 of 3 designs' "$seen/err"
claim "all are done" [ "$(grep -c ',done,0,$' cluster/results.csv)" -eq 3 ]
claim "the designs are tasks of that job" [ "$(find cluster -maxdepth 1 -name 'slurm-*_[123].log' | wc -l)" -eq 3 ]
if [ -n "$(type -P parallel)" ]; then
    runs "$sweep rods.yaml --folder here"
    claim "the table equals that of GNU parallel" cmp here/results.csv cluster/results.csv
fi
runs "$sweep rods.yaml --engine slurm --folder later --submit-only"
claim "the message says how to collect the results" grep -q 'the same command without --submit-only collects the results' "$seen/err"
for _ in {1..240}; do
    if [ -z "$(squeue --noheader)" ]; then break; fi
    sleep 0.5
done
runs "$sweep rods.yaml --engine slurm --folder later"
claim "results of the job are not computed again" grep -q ' 3 designs, 0 to compute ' "$seen/err"
claim "the results are collected" cmp cluster/results.csv later/results.csv
