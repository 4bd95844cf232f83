#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# An exception that ends a Python script on one rank ends all ranks, with its traceback and a non-zero status.
# $2 is the Python interpreter.
. "$(dirname "$0")/../support/run.sh"
python=$2
cat >"$work/script.py" <<'SCRIPT'
import thaw
body = {'name': 'drop', 'material': 'water', 'box': {'size': [0.3, 0.3, 0.3]}}
sim = thaw.Simulation({
    'spacing': 0.1,
    'end': 1,
    'domain': {'min': [-1, -1, -1], 'max': [1, 1, 1]},
    'material': {'water': {'phase': 'liquid'}},
    'body': [body],
})
sim.run(steps=2)
if sim.rank == sim.ranks - 1:
    raise ValueError('mine')
sim.ledger
print('not reached')
SCRIPT
PYTHONPATH=$build/python timeout 100 "${mpi[@]}" -n 3 "$python" "$work/script.py" >"$work/log" 2>&1
code=$?
[ $code -ne 0 ] && [ $code -ne 124 ] || fail "exit $code"
expectMessage 'ValueError: mine' "the exception"
grep -q 'not reached' "$work/log" && fail "a rank went on"
finish
