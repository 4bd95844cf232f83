#!/usr/bin/env bash
# matrix_test.sh BUILD: the tools around the accuracy suite (benchmarks/accuracy/*.py): the matrix resumes,
# fills orders and marks defaults; the committed document and what `thaw check` knows follow from the
# committed figures.
exec "$(command -v /usr/bin/python3 || command -v python3)" -B "$(dirname "$0")/matrix_test.py" "$1"
