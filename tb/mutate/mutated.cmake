# SPDX-License-Identifier: Apache-2.0
# rung_mutated(LIBRARY NAME SOURCES ARGUMENTS): where `make mutate` has written a mutated netlist NAME.v,
# the sources and Verilator arguments of a model (names of two variables) become those of the netlist:
# it takes the place of the files that NAME.txt names, and has its parameters in it. LIBRARY gets what
# chooses a mutant at run time. Without RUNG_MUTANTS nothing is changed.
function(rung_mutated library name sources_in arguments_in)
  if(NOT RUNG_MUTANTS OR NOT EXISTS ${RUNG_MUTANTS}/${name}.v)
    return()
  endif()
  file(STRINGS ${RUNG_MUTANTS}/${name}.txt replaced)
  list(TRANSFORM replaced PREPEND ${RUNG_ROOT}/)
  set(netlist_sources ${${sources_in}})
  list(REMOVE_ITEM netlist_sources ${replaced})
  set(netlist_arguments ${${arguments_in}})
  list(REMOVE_ITEM netlist_arguments -Wall)
  list(FILTER netlist_arguments EXCLUDE REGEX "^-G")
  set(${sources_in} ${RUNG_MUTANTS}/${name}.v ${netlist_sources} PARENT_SCOPE)
  set(${arguments_in} -Wno-fatal -Wno-lint -Wno-style ${netlist_arguments} PARENT_SCOPE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${RUNG_MUTANTS}/${name}.v)
  get_target_property(linked ${library} SOURCES)
  if(NOT "${RUNG_ROOT}/tb/mutate/mutant.cpp" IN_LIST linked)
    target_sources(${library} PRIVATE ${RUNG_ROOT}/tb/mutate/mutant.cpp)
  endif()
endfunction()
