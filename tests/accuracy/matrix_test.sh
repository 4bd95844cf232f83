#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# matrix_test.sh BUILD: tools of the accuracy suite (benchmarks/accuracy/*.py). The matrix resumes, computes
# orders and marks defaults. The committed document and the table of `thaw check` follow from the committed
# figures.
exec "$(command -v /usr/bin/python3 || command -v python3)" -B "$(dirname "$0")/matrix_test.py" "$1"
