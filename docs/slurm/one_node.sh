#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# One node under SLURM. Submit it with: sbatch docs/slurm/one_node.sh [SCENE]
# SLURM sends USR1 five minutes before the time limit. thaw then writes a checkpoint and exits with 75, and
# the job resubmits itself to continue. The chain ends when the run is done (0) or has failed (any other
# code).
#SBATCH --job-name=thaw
#SBATCH --nodes=1
#SBATCH --ntasks-per-node=64
#SBATCH --cpus-per-task=1
#SBATCH --time=12:00:00
#SBATCH --signal=USR1@300
#SBATCH --output=thaw-%j.log
set -u
scene=${1:-scenes/melt_large.toml}
out=${OUT:-${SCRATCH:-$PWD/out}/$(basename "$scene" .toml)}
thaw=${THAW:-build/release/thaw}

# Submits the next job with the options of this one, those of sbatch's command line included.
again() {
  local same=() o variable limit
  for o in nodes=SLURM_JOB_NUM_NODES ntasks-per-node=SLURM_NTASKS_PER_NODE account=SLURM_JOB_ACCOUNT \
    partition=SLURM_JOB_PARTITION qos=SLURM_JOB_QOS reservation=SLURM_JOB_RESERVATION \
    mem=SLURM_MEM_PER_NODE mem-per-cpu=SLURM_MEM_PER_CPU cpus-per-task=SLURM_CPUS_PER_TASK; do
    variable=${o#*=}
    [ -z "${!variable:-}" ] || same+=("--${o%%=*}=${!variable}")
  done
  limit=$(squeue --noheader --job "${SLURM_JOB_ID:-0}" --format %l 2>/dev/null) && [ -n "$limit" ] &&
    same+=("--time=$limit")
  sbatch "${same[@]}" "$@"
}

# A requeued job may find the lock of its run, left on another node. That run is over, so --force
# takes the folder.
force=()
if [ "${SLURM_RESTART_COUNT:-0}" -gt 0 ]; then force=(--force); fi

# srun forwards the signal to all ranks. Debian's Open MPI has PMIx; elsewhere see `srun --mpi=list`
# and set PMI.
code=0
srun --mpi="${PMI:-pmix}" --kill-on-bad-exit=1 "$thaw" run "$scene" --out "$out" --resume "${force[@]}" ||
  code=$?
case $code in
  0) "$thaw" render "$out" --sheet "$out/pictures/sheet.png" ;;
  75) again "$0" "$scene" ;;
esac
exit "$code"
