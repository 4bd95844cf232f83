# SPDX-License-Identifier: Apache-2.0
# cmake --install: executable, libraries, headers, scenes, and the package that find_package(thaw) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(libraries thaw_options thaw_core thaw_io)
if(TARGET thaw_parallel)
  list(APPEND libraries thaw_parallel)
endif()
foreach(library ${libraries})
  string(REPLACE "thaw_" "" short ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${short})
  add_library(thaw::${short} ALIAS ${library})
endforeach()
install(TARGETS ${libraries} EXPORT thawTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET thaw)
  install(TARGETS thaw RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
# The program itself prints its man page and the completion of its command line.
if(TARGET thaw AND NOT CMAKE_CROSSCOMPILING)
  install(CODE "set(THAW_PROGRAM \"$<TARGET_FILE:thaw>\")
    set(THAW_PAGES \"${PROJECT_BINARY_DIR}/generated\")
    set(THAW_DATA \"${CMAKE_INSTALL_DATADIR}\")
    set(THAW_MAN \"${CMAKE_INSTALL_MANDIR}\")")
  install(SCRIPT cmake/command_pages.cmake)
endif()
# Headers include "core/...", so they keep their folders below include/thaw.
install(CODE "set(THAW_SOURCE \"${PROJECT_SOURCE_DIR}\")
  set(THAW_HEADERS \"${CMAKE_INSTALL_INCLUDEDIR}/thaw\")")
install(SCRIPT cmake/public_headers.cmake)
# The Python package alone: cmake --install BUILD --component python. A generated file has its version.
set(THAW_PYTHON_DIR ${CMAKE_INSTALL_LIBDIR}/python3/dist-packages CACHE STRING
  "folder of the Python package, relative to the prefix")
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/generated/_version.py CONTENT "VERSION = '${PROJECT_VERSION}'\n")
install(DIRECTORY python/thaw DESTINATION ${THAW_PYTHON_DIR} COMPONENT python OPTIONAL
  FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/generated/_version.py DESTINATION ${THAW_PYTHON_DIR}/thaw COMPONENT
  python)
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/thaw OPTIONAL)
# Results of the accuracy suite, which `thaw check` reads: beside the program in the build, and installed.
install(FILES docs/accuracy/frontier.csv DESTINATION ${CMAKE_INSTALL_DATADIR}/thaw)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/thaw)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/docs/accuracy/frontier.csv
  ${PROJECT_BINARY_DIR}/share/thaw/frontier.csv SYMBOLIC)
file(RELATIVE_PATH data_folder ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/thaw)
set_source_files_properties(io/commands/check/frontier_file.cpp PROPERTIES COMPILE_DEFINITIONS
  THAW_DATA_FOLDER="${data_folder}")
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/thaw)
install(EXPORT thawTargets NAMESPACE thaw:: DESTINATION ${package_folder})
configure_package_config_file(cmake/thawConfig.cmake.in ${PROJECT_BINARY_DIR}/thawConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/thawConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/thawConfig.cmake ${PROJECT_BINARY_DIR}/thawConfigVersion.cmake
  cmake/instruction_sets.cmake DESTINATION ${package_folder})
