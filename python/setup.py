# SPDX-License-Identifier: Apache-2.0
"""Takes the version from CMakeLists.txt and writes it into the installed package (python/thaw/version.py)."""
import pathlib
import re

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent


def version():
    """Version of CMakeLists.txt; in a source archive of the package, that of its PKG-INFO."""
    for path, pattern in (
        (HERE.parent / 'CMakeLists.txt', r'project\(thaw VERSION ([\d.]+)'),
        (HERE / 'PKG-INFO', r'(?m)^Version: (\S+)'),
    ):
        match = re.search(pattern, path.read_text()) if path.exists() else None
        if match:
            return match[1]
    raise SystemExit('setup.py: expected ../CMakeLists.txt of thaw, which has the version')


class BuildWithVersion(build_py):
    def run(self):
        super().run()
        if not getattr(self, 'editable_mode', False):
            file = pathlib.Path(self.build_lib) / 'thaw' / '_version.py'
            file.write_text(f"VERSION = '{version()}'\n")


setup(version=version(), cmdclass={'build_py': BuildWithVersion})
