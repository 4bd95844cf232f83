#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares the model of the scaling study (benchmarks/scaling/model.py) with counts and with the committed
# figures. docs/performance.md equals the output of its script.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
python3 "$here/benchmarks/scaling/test_model.py"
[ ! -f "$here/docs/scaling/scaling.csv" ] ||
  python3 "$here/benchmarks/scaling/model.py" "$here/docs/scaling/scaling.csv" --ranks 10000 --particles 1e10
python3 -B "$here/benchmarks/performance_chart.py" --check
