# SPDX-License-Identifier: Apache-2.0
"""Runs tests of the package against a build: run.py BUILD_FOLDER [--examples] [options of pytest].

--examples: those of examples/python, without it all others.
Exit status 77, with the reason, where numpy, h5py or pytest is missing.
"""
import importlib.util
import os
import pathlib
import sys


def main():
    if len(sys.argv) < 2:
        sys.exit('usage: run.py BUILD_FOLDER [--examples] [options of pytest]')
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
    options, examples = sys.argv[2:], here + '/test_examples.py'
    chosen = [here, '--ignore', examples, '--ignore', here + '/test_simulation.py']  # the latter by mpirun
    if options[:1] == ['--examples']:
        options, chosen = options[1:], [examples]
    return pytest.main(['-q', '-p', 'no:cacheprovider', '--rootdir', here, *chosen, *options])


if __name__ == '__main__':
    sys.exit(main())
