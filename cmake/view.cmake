# SPDX-License-Identifier: Apache-2.0
# `thaw view`: a server (cpp-httplib) and a page (viewer/) that is bundled into the program. Both are
# optional: without them all else builds, and `thaw view` reports how to get them.
set(THAW_VIEW AUTO CACHE STRING "`thaw view`: AUTO (if its packages are there), ON (error if not) or OFF")
set_property(CACHE THAW_VIEW PROPERTY STRINGS AUTO ON OFF)
set(THAW_VIEW_MODULES ${PROJECT_SOURCE_DIR}/build/viewer/node_modules CACHE PATH
  "packages of viewer/package-lock.json, which scripts/view installs")
set(view_missing "")

# Debian's header needs the definitions of its library, which pkg-config has. Elsewhere it may be a CMake
# package.
if(THAW_VIEW)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(HTTPLIB QUIET IMPORTED_TARGET cpp-httplib)
  endif()
  if(HTTPLIB_FOUND)
    set(httplib PkgConfig::HTTPLIB)
  else()
    find_package(httplib QUIET)
    if(httplib_FOUND)
      set(httplib httplib::httplib)
    else()
      list(APPEND view_missing "cpp-httplib (Debian: libcpp-httplib-dev)")
    endif()
  endif()
  find_program(NODE node)
  if(NOT NODE)
    list(APPEND view_missing "node (Debian: nodejs, npm)")
  elseif(NOT EXISTS ${THAW_VIEW_MODULES}/three OR NOT EXISTS ${THAW_VIEW_MODULES}/uplot
      OR NOT EXISTS ${THAW_VIEW_MODULES}/esbuild)
    list(APPEND view_missing "the packages of viewer/package-lock.json in ${THAW_VIEW_MODULES}")
  endif()
  if(view_missing)
    list(JOIN view_missing "; " names)
    set(text "thaw view is built without: ${names}. scripts/view installs what is missing.")
    if(THAW_VIEW STREQUAL "AUTO")
      message(STATUS "${text}")
    else()
      message(FATAL_ERROR "${text}")
    endif()
  endif()
endif()

file(GLOB_RECURSE view_sources CONFIGURE_DEPENDS io/view/*.cpp)
list(FILTER view_sources EXCLUDE REGEX "/(serve|serve_missing|page_missing)\\.cpp$")
foreach(command view export preview)
  list(APPEND view_sources ${PROJECT_SOURCE_DIR}/io/commands/${command}.cpp)
endforeach()
file(GLOB export_sources CONFIGURE_DEPENDS io/commands/export/*.cpp)
list(APPEND view_sources ${export_sources})
set(view_server ${PROJECT_SOURCE_DIR}/io/view/server)
list(APPEND view_sources ${view_server}/$<IF:$<BOOL:${httplib}>,serve.cpp,serve_missing.cpp>)

# The page: bundled by node, and included into a generated source as bytes.
set(page_missing ${view_missing})
list(FILTER page_missing EXCLUDE REGEX "httplib")
if(THAW_VIEW AND NOT page_missing)
  set(page_folder ${PROJECT_BINARY_DIR}/generated/page)
  set(page_files index.html viewer.js viewer.css licences.txt)
  set(page_types "text/html" "text/javascript" "text/css" "text/plain")
  set(page_source ${page_folder}/page_files.cpp)
  file(GLOB_RECURSE page_inputs CONFIGURE_DEPENDS viewer/*)
  list(TRANSFORM page_files PREPEND ${page_folder}/ OUTPUT_VARIABLE page_outputs)
  add_custom_command(OUTPUT ${page_outputs} DEPENDS ${page_inputs} VERBATIM
    COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/viewer/build.mjs ${THAW_VIEW_MODULES} ${page_folder})
  set(PAGE_SYMBOLS "")
  set(PAGE_ENTRIES "")
  foreach(file type IN ZIP_LISTS page_files page_types)
    string(MAKE_C_IDENTIFIER ${file} symbol)
    string(APPEND PAGE_SYMBOLS "THAW_PAGE_FILE(${symbol}, \"${page_folder}/${file}\")\n")
    string(APPEND PAGE_ENTRIES
      "    {\"${file}\", \"${type}; charset=utf-8\", bytes(page_${symbol}, page_${symbol}_end)},\n")
  endforeach()
  configure_file(cmake/page_files.cpp.in ${page_source} @ONLY)
  # A unity file would not be built anew after a change of the page.
  set_source_files_properties(${page_source} PROPERTIES OBJECT_DEPENDS "${page_outputs}"
    SKIP_UNITY_BUILD_INCLUSION ON)
  list(APPEND view_sources ${page_source})
else()
  list(APPEND view_sources ${view_server}/page_missing.cpp)
endif()

add_library(thaw_view STATIC ${view_sources})
thaw_unity(thaw_view ${view_sources})
target_precompile_headers(thaw_view REUSE_FROM thaw_io)
target_link_libraries(thaw_view PUBLIC thaw_io PRIVATE ZLIB::ZLIB)  # a part of PNG::PNG
if(httplib)
  # its definitions and its 2,000 lines concern one source
  target_link_libraries(thaw_view PRIVATE ${httplib})
endif()
