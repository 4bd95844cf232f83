# SPDX-License-Identifier: Apache-2.0
# OpenVDB for `thaw export --as vdb`, which is optional: without it everything else builds, and the command
# reports how to install it.
set(THAW_OPENVDB AUTO CACHE STRING
  "`thaw export --as vdb`: AUTO (if OpenVDB is found), ON (error if it is not) or OFF")
set_property(CACHE THAW_OPENVDB PROPERTY STRINGS AUTO ON OFF)
set(openvdb "")
if(THAW_OPENVDB)
  # Debian's CMake does not find the module of OpenVDB, which also requires packages of the tools.
  find_path(OPENVDB_INCLUDE openvdb/openvdb.h)
  find_library(OPENVDB_LIBRARY openvdb)
  find_library(OPENVDB_TBB tbb)
  find_library(OPENVDB_HALF NAMES Imath Imath-3_1 Half)  # half precision, which its headers use
  if(OPENVDB_INCLUDE AND OPENVDB_LIBRARY AND OPENVDB_TBB AND OPENVDB_HALF)
    set(openvdb ${OPENVDB_LIBRARY} ${OPENVDB_TBB} ${OPENVDB_HALF})
  elseif(THAW_OPENVDB STREQUAL "AUTO")
    message(STATUS "thaw export --as vdb is built without OpenVDB (Debian: libopenvdb-dev)")
  else()
    message(FATAL_ERROR "OpenVDB is not found (Debian: libopenvdb-dev)")
  endif()
endif()
if(openvdb)
  list(REMOVE_ITEM io_sources ${PROJECT_SOURCE_DIR}/io/export/write_vdb_missing.cpp)
else()
  list(REMOVE_ITEM io_sources ${PROJECT_SOURCE_DIR}/io/export/write_vdb.cpp)
endif()
