#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# An array of runs under SLURM, one per line of a list. Submit it with: sbatch --array=1-$(wc -l <LIST)
# docs/slurm/array.sh LIST
# A line of the list has a scene and options of `thaw run`, in quotes where they contain blanks:
#   scenes/pour.toml --set material.honey.viscosity=2
#   scenes/pour.toml --set 'spacing="2 mm"'
# Each run has its own folder, named by the scene and the line's number. A run that is not done five minutes
# before the time limit writes a checkpoint, and its task alone is resubmitted to continue from there.
# Finished lines end at once: after adding lines, or after a failure, submit the whole list again.
#SBATCH --job-name=thaw-array
#SBATCH --nodes=1
#SBATCH --ntasks=16
#SBATCH --cpus-per-task=1
#SBATCH --time=04:00:00
#SBATCH --signal=USR1@300
#SBATCH --output=thaw-%A_%a.log
set -u
list=${1:?a file with a scene and its options on each line}
number=${SLURM_ARRAY_TASK_ID:?submit with --array}
line=$(sed -n "${number}p" "$list")
[ -n "$line" ] || { echo "$list has no line $number"; exit 0; }
run=()
eval "run=($line)"  # the quotes of the line
name=$(basename "${run[0]}" .toml)
out=${OUT:-${SCRATCH:-$PWD/out}}/$name.$number
thaw=${THAW:-build/release/thaw}

# Submits the next job with the options of this one, those of sbatch's command line included.
again() {
  local same=() o variable limit
  for o in ntasks=SLURM_NTASKS account=SLURM_JOB_ACCOUNT partition=SLURM_JOB_PARTITION qos=SLURM_JOB_QOS \
    reservation=SLURM_JOB_RESERVATION \
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

code=0
srun --mpi="${PMI:-pmix}" --kill-on-bad-exit=1 "$thaw" run "${run[@]}" --out "$out" --resume "${force[@]}" ||
  code=$?
[ "$code" -ne 75 ] || again --array="$number" "$0" "$list"
exit "$code"
