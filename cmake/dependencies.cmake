# SPDX-License-Identifier: Apache-2.0
# Finds all packages that thaw is built with. All that are missing are listed in one error, with the packages
# of Debian and Spack that have them.
set(thaw_missing "")

# thaw_find(PACKAGE VERSION PURPOSE NAMES [arguments of find_package])
# VERSION: oldest accepted one, or "any". NAMES: "Debian package, Spack package".
macro(thaw_find package version purpose names)
  if("${version}" STREQUAL "any")
    find_package(${package} QUIET ${ARGN})
    set(thaw_wanted "${package}")
  else()
    find_package(${package} ${version} QUIET ${ARGN})
    set(thaw_wanted "${package} ${version} or newer")
  endif()
  if(NOT ${package}_FOUND)
    set(thaw_found "")
    if(${package}_CONSIDERED_VERSIONS)
      set(thaw_found "; found ${${package}_CONSIDERED_VERSIONS}")
    endif()
    string(APPEND thaw_missing "\n  ${thaw_wanted}, ${purpose} (${names})${thaw_found}")
  endif()
endmacro()

# Compilers that lack parts of C++20 fail in the middle of the build with obscure messages.
set(thaw_oldest_GNU 11)
set(thaw_oldest_Clang 14)
set(thaw_oldest ${thaw_oldest_${CMAKE_CXX_COMPILER_ID}})
if(thaw_oldest AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS thaw_oldest)
  message(FATAL_ERROR "thaw is C++20: ${CMAKE_CXX_COMPILER_ID} ${thaw_oldest} or newer is required, and "
    "${CMAKE_CXX_COMPILER} has version ${CMAKE_CXX_COMPILER_VERSION}. Select another one with CXX=... or "
    "-DCMAKE_CXX_COMPILER=...")
endif()

thaw_find(MPI 3.0 "communication between ranks" "Debian: libopenmpi-dev; Spack: mpi" COMPONENTS CXX C)
thaw_find(Eigen3 3.3 "small dense matrices" "Debian: libeigen3-dev; Spack: eigen" NO_MODULE)
thaw_find(nanoflann 1.4.2 "nearest points" "Debian: libnanoflann-dev; Spack: nanoflann")
thaw_find(tomlplusplus 3.3.0 "scene files" "Debian: libtomlplusplus-dev; Spack: tomlplusplus")
thaw_find(CLI11 2.1.2 "the command line" "Debian: libcli11-dev; Spack: cli11")
thaw_find(fmt 9.1.0 "text" "Debian: libfmt-dev; Spack: fmt")
thaw_find(nlohmann_json 3.11.2 "summaries" "Debian: nlohmann-json3-dev; Spack: nlohmann-json")
thaw_find(muparser 2.3 "expressions in scenes" "Debian: libmuparser-dev; Spack: muparser")
thaw_find(PNG 1.6.39 "pictures" "Debian: libpng-dev; Spack: libpng")
thaw_find(Threads any "threads of render and export" "the C library")
set(HDF5_PREFER_PARALLEL ON)
thaw_find(HDF5 1.10.7 "frames and checkpoints" "Debian: libhdf5-openmpi-dev; Spack: hdf5+mpi" COMPONENTS C)
if(HDF5_FOUND AND NOT HDF5_IS_PARALLEL)
  string(APPEND thaw_missing "\n  HDF5 with MPI: the HDF5 ${HDF5_VERSION} that was found is serial "
    "(Debian: libhdf5-openmpi-dev; Spack: hdf5+mpi); HDF5_ROOT or HDF5_DIR selects another one")
endif()
if(THAW_TESTS)
  thaw_find(GTest 1.12.1 "tests; -DTHAW_TESTS=OFF builds none" "Debian: libgtest-dev; Spack: googletest")
endif()
if(thaw_missing)
  message(FATAL_ERROR "thaw needs these packages, which CMake does not find:${thaw_missing}\n"
    "Packages in a folder of your own: -DCMAKE_PREFIX_PATH=DIR. docs/howto/install.md has more.")
endif()
