# SPDX-License-Identifier: Apache-2.0
# Installs the public headers and those that they include. The others are no part of the package.
# Runs at installation, with THAW_SOURCE and THAW_HEADERS (folder below the prefix).
cmake_policy(VERSION 3.22)  # the oldest that CMakeLists.txt accepts
set(public
  core/terms/extensions.hpp           # forces, fields, laws and shapes with keys in scenes
  core/fluid/terms/extension_pair_force_term.hpp
  core/simd/choose.hpp
  core/solid/elasticity/extension_law_lanes.hpp
  core/simulation/world/body_types.hpp
  core/simulation/ledger/report.hpp   # energy, momentum and mass
  core/math/exact_sum.hpp
  core/scene/scene.hpp                # a scene as a plain struct
  core/simulation/setup/serial_simulation.hpp  # from a scene to its steps, in one process
  core/simulation/step.hpp            # one time step
  core/surface/update_surface.hpp
  core/time/frame_times.hpp           # frames due, and the next step
  parallel/balance.hpp
  parallel/mpi_simulation.hpp         # the same on the ranks of a communicator
  parallel/row_scatter.hpp
  io/meshes/read_mesh.hpp
  io/scene/read_scene.hpp             # a scene from a file
  io/simulation/simulation.hpp        # a simulation as a program sees it
  io/simulation/driven_obstacle.hpp    # an obstacle that a program moves
  io/text/version.hpp)

set(headers "")
while(public)
  list(POP_FRONT public header)
  list(APPEND headers ${header})
  file(STRINGS ${THAW_SOURCE}/${header} includes REGEX "^#include \"")
  foreach(line ${includes})
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
    if(NOT included IN_LIST headers AND NOT included IN_LIST public)
      list(APPEND public ${included})
    endif()
  endforeach()
endwhile()
foreach(header ${headers})
  get_filename_component(folder ${header} DIRECTORY)
  file(INSTALL ${THAW_SOURCE}/${header} DESTINATION ${CMAKE_INSTALL_PREFIX}/${THAW_HEADERS}/${folder})
endforeach()
