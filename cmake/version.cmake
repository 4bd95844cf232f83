# SPDX-License-Identifier: Apache-2.0
# Writes the version and the commit into a source file, at build time; the file is left alone if nothing
# changed.
# Called as: cmake -DTHAW_SOURCE=... -DTHAW_VERSION=... -DTHAW_OUTPUT=... -P version.cmake
set(THAW_COMMIT unknown)
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${THAW_SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit
    RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(THAW_COMMIT ${commit})
    execute_process(COMMAND ${GIT} -C ${THAW_SOURCE} diff-index --quiet HEAD -- RESULT_VARIABLE changed
      OUTPUT_QUIET ERROR_QUIET)
    if(changed)
      string(APPEND THAW_COMMIT "+")
    endif()
  endif()
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/version.cpp.in ${THAW_OUTPUT} @ONLY)
