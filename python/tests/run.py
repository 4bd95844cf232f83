# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of the package against a build: run.py BUILD_FOLDER [options of pytest].

Exit status 77, with the reason, where numpy, h5py or pytest is missing.
"""
import importlib.util
import os
import pathlib
import sys


def main():
    if len(sys.argv) < 2:
        sys.exit('usage: run.py BUILD_FOLDER [options of pytest]')
    missing = [name for name in ('numpy', 'h5py', 'pytest') if importlib.util.find_spec(name) is None]
    if missing:
        packages = ' '.join(f'python3-{name}' for name in missing)
        print(f'skipped: {sys.executable} has no {", ".join(missing)} (Debian: apt install {packages})')
        return 77
    import pytest

    build = pathlib.Path(sys.argv[1]).resolve()
    os.environ['THAW_BUILD'] = str(build)
    os.environ['THAW_PROGRAM'] = str(build / 'thaw')
    sys.dont_write_bytecode = True
    here = str(pathlib.Path(__file__).resolve().parent)
    simulations = here + '/test_simulation.py'  # on several numbers of ranks (tests/CMakeLists.txt)
    return pytest.main(
        ['-q', '-p', 'no:cacheprovider', '--rootdir', here, here, '--ignore', simulations, *sys.argv[2:]]
    )


if __name__ == '__main__':
    sys.exit(main())
