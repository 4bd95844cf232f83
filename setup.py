# SPDX-License-Identifier: Apache-2.0
"""Builds the Python package by CMake, with the flags of the release preset and without tests.

The build folder is build/pip, or THAW_BUILD. CMake finds the packages that thaw needs.
"""
import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def run(self):
        build = os.environ.get('THAW_BUILD', str(HERE / 'build/pip'))
        options = ['-DTHAW_TESTS=OFF', '-DTHAW_VIEW=OFF', '-DTHAW_PYTHON=ON', '-DTHAW_PYTHON_DIR=.']
        options += [f'-DPython3_EXECUTABLE={sys.executable}']
        self.cmake('--preset', 'release', '-B', build, *options)
        self.cmake('--build', build, '--target', 'thaw_python')
        self.cmake('--install', build, '--component', 'python', '--prefix', os.path.abspath(self.build_lib))

    def cmake(self, *arguments):
        subprocess.run(['cmake', *arguments], cwd=HERE, check=True)


version = re.search(r'project\(thaw VERSION ([\d.]+)', (HERE / 'CMakeLists.txt').read_text())[1]
setup(version=version, ext_modules=[Extension('thaw._core', [])], cmdclass={'build_ext': CMakeBuild})
