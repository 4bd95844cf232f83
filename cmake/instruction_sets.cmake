# SPDX-License-Identifier: Apache-2.0
# thaw_instruction_sets(TARGET FILE...): compiles the files once for each instruction set, with THAW_ISA as
# the name of its namespace, and adds them to the target. THAW_CHOOSE (core/simd/choose.hpp) chooses among the
# sets at run time. All sets give the same bits. The files may include only headers for lanes
# (core/simd/lanes.hpp, core/fluid/terms/extension_pair_force_term.hpp,
# core/solid/elasticity/extension_law_lanes.hpp). They must use no containers of the standard library: the
# linker would mix up their copies.
include(CheckCXXCompilerFlag)
function(thaw_instruction_sets target)
  set(sets base)
  set(flags_base "")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    # as the library's own loops (CMakeLists.txt)
    list(APPEND sets avx2 avx512)
    set(flags_base $<$<NOT:$<CONFIG:Debug>>:-O1>)
    set(flags_avx2 -mavx2 -mfma -mbmi -mbmi2)
    check_cxx_compiler_flag(-mmove-max=256 THAW_HAS_MOVE_MAX)
    if(THAW_HAS_MOVE_MAX)
      list(APPEND flags_avx2 -mmove-max=256 -mstore-max=256)
    endif()
    set(vector_zeros "-mmemset-strategy=vector_loop:2048:noalign,libcall:-1:noalign")
    check_cxx_compiler_flag("${vector_zeros}" THAW_HAS_MEMSET_STRATEGY)
    if(THAW_HAS_MEMSET_STRATEGY)
      list(APPEND flags_avx2 "${vector_zeros}")
    endif()
    set(flags_avx512 ${flags_avx2} -mavx512f -mavx512vl -mavx512bw -mprefer-vector-width=256)
  endif()
  foreach(set ${sets})
    set(library ${target}_${set})
    add_library(${library} OBJECT ${ARGN})
    target_link_libraries(${library} PRIVATE thaw::core)
    target_compile_options(${library} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O3> ${flags_${set}})
    target_compile_definitions(${library} PRIVATE THAW_ISA=isa_${set})
    set_target_properties(${library} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
endfunction()
