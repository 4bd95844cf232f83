# SPDX-License-Identifier: Apache-2.0
# The compiled part of the Python package, beside links to python/thaw in <build>/python/thaw, and in the
# installation.
# THAW_PYTHON: AUTO builds it where Python's headers and pybind11 are, ON requires them, OFF leaves it out.
set(THAW_PYTHON AUTO CACHE STRING "AUTO, ON or OFF: the Python package")
if(THAW_PYTHON STREQUAL "OFF")
  return()
endif()
# The first interpreter that has numpy: others on the PATH may not be Debian's.
if(NOT Python3_EXECUTABLE)
  foreach(candidate python3 /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy, sys; print(sys.executable)"
      OUTPUT_VARIABLE found RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT failed)
      set(Python3_EXECUTABLE ${found})
      break()
    endif()
  endforeach()
endif()
find_package(Python3 COMPONENTS Interpreter Development.Module QUIET)
find_package(pybind11 CONFIG QUIET)
if(NOT Python3_Development.Module_FOUND OR NOT pybind11_FOUND)
  if(THAW_PYTHON STREQUAL "ON")
    message(FATAL_ERROR
      "THAW_PYTHON=ON needs Python's headers and pybind11 (Debian: python3-dev pybind11-dev)")
  endif()
  message(STATUS "The Python package is left out: Python's headers or pybind11 are missing")
  return()
endif()

file(GLOB python_sources CONFIGURE_DEPENDS python/src/*.cpp)
pybind11_add_module(thaw_python MODULE NO_EXTRAS ${python_sources})
target_link_libraries(thaw_python PRIVATE thaw_io)
target_compile_options(thaw_python PRIVATE $<$<CONFIG:Release>:-O1>)
set_target_properties(thaw_python PROPERTIES OUTPUT_NAME _core
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/python/thaw)
file(GLOB python_files CONFIGURE_DEPENDS python/thaw/*.py python/thaw/*.pyi python/thaw/py.typed)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/python/thaw)
foreach(file ${python_files})
  get_filename_component(name ${file} NAME)
  file(CREATE_LINK ${file} ${PROJECT_BINARY_DIR}/python/thaw/${name} SYMBOLIC)
endforeach()
install(TARGETS thaw_python LIBRARY DESTINATION ${THAW_PYTHON_DIR}/thaw COMPONENT python)
