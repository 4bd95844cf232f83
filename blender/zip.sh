#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes the Blender add-on as build/thaw_io.zip, or to the path given: blender/zip.sh [FILE.zip]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
file=$(realpath -m "${1:-$here/../build/thaw_io.zip}")
mkdir -p "$(dirname "$file")"
rm -f "$file"
cd "$here"
python3 - "$file" <<'PYTHON'
import pathlib
import sys
import zipfile

with zipfile.ZipFile(sys.argv[1], 'w', zipfile.ZIP_DEFLATED) as archive:
    for path in sorted(pathlib.Path('thaw_io').glob('*.py')):
        archive.write(path)
PYTHON
printf '%s\n' "$file"
