# SPDX-License-Identifier: Apache-2.0
"""Spack recipe. From the root of the source tree:

    spack repo add scripts/install/spack
    spack dev-build thaw@0.2.0
"""
from spack.package import *

try:
    from spack_repo.builtin.build_systems.cmake import CMakePackage
except ImportError:  # Spack before 1.0 has it in spack.package
    pass


class Thaw(CMakePackage):
    """Simulation of solids and liquids that deform, melt, flow, freeze and break, as particles over MPI."""

    license("Apache-2.0")

    version("0.2.0")

    variant("tests", default=False, description="build the tests")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.22:", type="build")
    depends_on("ninja", type="build")
    depends_on("googletest", type="build", when="+tests")
    depends_on("mpi@3:")
    depends_on("hdf5@1.10.7:+mpi")
    depends_on("eigen@3.3:3", type="build")
    depends_on("nanoflann@1.4:", type="build")
    depends_on("tomlplusplus@3:")
    depends_on("cli11@2:")
    depends_on("fmt@9:")
    depends_on("nlohmann-json@3.11:")
    depends_on("muparser@2.3:")
    depends_on("libpng")

    conflicts("%gcc@:10", msg="thaw is C++20")
    conflicts("%clang@:13", msg="thaw is C++20")

    generator("ninja")

    def cmake_args(self):
        return [self.define_from_variant("THAW_TESTS", "tests"), self.define("THAW_WERROR", False)]
