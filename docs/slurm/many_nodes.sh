#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Many nodes under SLURM. Submit it with: sbatch --nodes=16 docs/slurm/many_nodes.sh [SCENE]
# --out must be on a parallel file system that all nodes see: OUT, else $SCRATCH, else ./out. SLURM sends USR1
# ten minutes before the time limit. thaw then writes a checkpoint and exits with 75, and the job resubmits
# itself with the same nodes, account, partition and time. A run ended by a node's failure (any other code) is
# resubmitted at most RETRIES times in a row. It continues from its last checkpoint, so give the scene a short
# [output] checkpoint. A failure that repeats at the same step is not the machine's, and ends the chain.
#SBATCH --job-name=thaw
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=64
#SBATCH --cpus-per-task=1
#SBATCH --distribution=block:block
#SBATCH --exclusive
#SBATCH --time=24:00:00
#SBATCH --signal=USR1@600
#SBATCH --output=thaw-%j.log
set -u
scene=${1:-scenes/melt_large.toml}
failed=${2:-0} failedAt=${3:-none}
out=${OUT:-${SCRATCH:-$PWD/out}/$(basename "$scene" .toml)}
thaw=${THAW:-build/release/thaw}

# All ranks write a file of 100 GB at once, so spread it over the servers of the file system, if that is
# Lustre. New files inherit it.
mkdir -p "$out/frames" "$out/checkpoint"
if command -v lfs >/dev/null; then
  lfs setstripe --stripe-count "${STRIPES:-16}" --stripe-size 16M "$out/frames" "$out/checkpoint" \
    2>/dev/null || true
fi

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

# A run ended by a failed node leaves its lock in the folder, perhaps for other nodes. That run is over, so
# --force takes the folder.
force=()
if [ "$failed" -gt 0 ] || [ "${SLURM_RESTART_COUNT:-0}" -gt 0 ]; then force=(--force); fi

code=0
srun --mpi="${PMI:-pmix}" --cpu-bind=cores --kill-on-bad-exit=1 "$thaw" run "$scene" --out "$out" \
  --resume "${force[@]}" || code=$?
case $code in
  0) "$thaw" render "$out" --sheet "$out/pictures/sheet.png" ;;
  75) again "$0" "$scene" ;;
  2 | 3 | 4) ;;  # a bad scene, a full disk, a failed simulation: a repetition would fail again
  *)
    step=$("$thaw" info "$out" --json 2>/dev/null | sed -n 's/.*"step": *\([0-9]*\).*/\1/p' | head -n 1)
    if [ "$failed" -lt "${RETRIES:-3}" ] && [ "${step:-none}" != "$failedAt" ]; then
      again "$0" "$scene" $((failed + 1)) "${step:-none}"
    fi
    ;;
esac
exit "$code"
