#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The scripts of docs/slurm/ with stand-ins for srun, sbatch and thaw that log their arguments: which jobs are
# resubmitted after which exit code.
. "$(dirname "$0")/../support/run.sh"
mkdir "$work/bin"
PATH=$work/bin:$PATH
cat >"$work/bin/srun" <<'END_SRUN'
#!/usr/bin/env bash
while [[ $1 == -* ]]; do shift; done
"$@"
END_SRUN
cat >"$work/bin/sbatch" <<'END_SBATCH'
#!/usr/bin/env bash
printf '%s\n' "$*" >>"$SAID/sbatch"
END_SBATCH
cat >"$work/bin/thaw" <<'END_THAW'
#!/usr/bin/env bash
printf '%s\n' "$*" >>"$SAID/thaw"
case $1 in
  run) exit "$CODE" ;;
  info) echo '{ "step": 120 }' ;;
esac
END_THAW
cat >"$work/bin/squeue" <<'END_SQUEUE'
#!/usr/bin/env bash
[ "$*" = "--noheader --job 77 --format %l" ] && echo 1-00:00:00
END_SQUEUE
chmod +x "$work/bin/"*
export SAID=$work THAW=thaw OUT=$work/out SLURM_JOB_NUM_NODES=3 SLURM_ARRAY_TASK_ID=2
printf '%s\n' "scenes/pour.toml" "scenes/drop.toml --set 'spacing=\"2 mm\"'" >"$work/list"
# script CODE EXPECTED-SBATCH ARGUMENTS...: EXPECTED-SBATCH holds the expected arguments of sbatch, or nothing
script() {
  local file=$1 code=$2 expected=$3
  shift 3
  rm -f "$work/sbatch" "$work/thaw"
  (cd "$source_dir" && CODE=$code bash "docs/slurm/$file" "$@") >"$work/log" 2>&1
  local got=$?
  [ "$got" -eq "$code" ] || fail "$file: exit $got, not $code"
  [ "$(cat "$work/sbatch" 2>/dev/null)" = "$expected" ] ||
    fail "$file after exit $code: sbatch got '$(cat "$work/sbatch" 2>/dev/null)', expected '$expected'"
}
for code in 0 2 3 4; do
  script many_nodes.sh $code "" scenes/melt.toml
  script array.sh $code "" "$work/list"
done
script many_nodes.sh 75 "--nodes=3 docs/slurm/many_nodes.sh scenes/melt.toml" scenes/melt.toml
script many_nodes.sh 137 "--nodes=3 docs/slurm/many_nodes.sh scenes/melt.toml 1 120" scenes/melt.toml
script many_nodes.sh 137 "--nodes=3 docs/slurm/many_nodes.sh scenes/melt.toml 3 120" scenes/melt.toml 2 80
grep -q -e "--resume --force$" "$work/thaw" ||
  fail "many_nodes.sh: a run that failed before does not take the folder"
SLURM_RESTART_COUNT=1 script one_node.sh 0 "" scenes/melt.toml
grep -q -e "--resume --force$" "$work/thaw" || fail "one_node.sh: requeued, it does not take the folder"
script many_nodes.sh 137 "" scenes/melt.toml 3 80   # RETRIES are used up
script many_nodes.sh 137 "" scenes/melt.toml 1 120  # an earlier failure at that step
# options on sbatch's command line also apply to the next job
(
  export SLURM_JOB_ID=77 SLURM_JOB_ACCOUNT=ice SLURM_JOB_PARTITION=long SLURM_JOB_QOS=normal \
    SLURM_NTASKS_PER_NODE=32 SLURM_NTASKS=8 SLURM_CPUS_PER_TASK=1 SLURM_MEM_PER_NODE=64000
  common="--account=ice --partition=long --qos=normal --mem=64000 --cpus-per-task=1 --time=1-00:00:00"
  script one_node.sh 75 "--nodes=3 --ntasks-per-node=32 $common docs/slurm/one_node.sh scenes/melt.toml" \
    scenes/melt.toml
  script many_nodes.sh 75 "--nodes=3 --ntasks-per-node=32 $common docs/slurm/many_nodes.sh scenes/melt.toml" \
    scenes/melt.toml
  script array.sh 75 "--ntasks=8 $common --array=2 docs/slurm/array.sh $work/list" "$work/list"
  [ "${failures:-0}" -eq 0 ]
) || fail "options of the command line"
script array.sh 75 "--array=2 docs/slurm/array.sh $work/list" "$work/list"
grep -qxF "run scenes/drop.toml --set spacing=\"2 mm\" --out $work/out/drop.2 --resume" "$work/thaw" || {
  fail "array.sh: thaw was called as"
  cat "$work/thaw"
}
SLURM_ARRAY_TASK_ID=3 script array.sh 0 "" "$work/list"
[ ! -e "$work/thaw" ] || fail "array.sh runs something for a missing line"
OUT='' SCRATCH=$work/scratch script one_node.sh 75 "--nodes=3 docs/slurm/one_node.sh scenes/melt.toml" \
  scenes/melt.toml
for file in "$source_dir"/docs/slurm/*.sh; do
  bash -n "$file" || fail "$file"
  ! command -v shellcheck >/dev/null || shellcheck "$file" || fail "shellcheck $file"
done
finish
