# SPDX-License-Identifier: Apache-2.0
# Installs thaw.1 and the completion for bash. Runs at installation, with THAW_PROGRAM, THAW_PAGES (folder of
# the build), THAW_MAN and THAW_DATA (folders below the prefix).
cmake_policy(VERSION 3.22)  # the oldest that CMakeLists.txt accepts
function(print_page file)
  # Leak checks of sanitizers would report Open MPI's leaks.
  execute_process(COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 ${THAW_PROGRAM} docs ${ARGN}
    OUTPUT_FILE ${THAW_PAGES}/${file} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${THAW_PROGRAM} docs ${ARGN} failed: ${failed}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${THAW_PAGES}/completions)
print_page(thaw.1 --man)
print_page(completions/thaw --completion bash)
file(INSTALL ${THAW_PAGES}/thaw.1 DESTINATION ${CMAKE_INSTALL_PREFIX}/${THAW_MAN}/man1)
file(INSTALL ${THAW_PAGES}/completions/thaw
  DESTINATION ${CMAKE_INSTALL_PREFIX}/${THAW_DATA}/bash-completion/completions)
