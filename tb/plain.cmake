# SPDX-License-Identifier: Apache-2.0
# rung_plain(TARGET): TARGET_plain, the same sources and libraries without the sanitizers.
#
# A program under the sanitizers takes five times as long. So of the tests with thousands of random
# programs the test build has two: all programs run in the plain one, the first RUNG_SANITIZED_COUNT
# of them in the sanitized one too. The Verilated models are without sanitizers anyway, and shared.
set(RUNG_SANITIZED_COUNT 500)

add_library(rung_options_plain INTERFACE)
# Subscripts are still checked.
target_compile_options(rung_options_plain INTERFACE
  -Wall -Wextra -Werror $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -O1 -g0)
target_compile_definitions(rung_options_plain INTERFACE _GLIBCXX_ASSERTIONS)
target_include_directories(rung_options_plain INTERFACE
  ${RUNG_ROOT}/compiler ${RUNG_GENERATED})

rung_alone(${CMAKE_CURRENT_SOURCE_DIR})

# What to link where `library` is linked: its plain twin if it is one of ours.
function(rung_plain_of library result)
  if(TARGET ${library} AND library MATCHES "^rung_" AND NOT library MATCHES "_models$")
    rung_plain(${library})
    set(library ${library}_plain)
  endif()
  set(${result} ${library} PARENT_SCOPE)
endfunction()

function(rung_plain target)
  if(TARGET ${target}_plain)
    return()
  endif()
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  list(TRANSFORM sources PREPEND ${folder}/ REGEX "^[^/]")
  get_target_property(type ${target} TYPE)
  if(type STREQUAL EXECUTABLE)
    add_executable(${target}_plain ${sources})
  else()
    add_library(${target}_plain STATIC ${sources})
  endif()
  foreach(property COMPILE_DEFINITIONS INCLUDE_DIRECTORIES INTERFACE_INCLUDE_DIRECTORIES C_STANDARD)
    get_target_property(value ${target} ${property})
    if(value)
      # Two programs that run at the same time must not write the same files.
      list(TRANSFORM value REPLACE "^RUNG_SCRATCH=.*" "RUNG_SCRATCH=\"${CMAKE_CURRENT_BINARY_DIR}\"")
      set_target_properties(${target}_plain PROPERTIES ${property} "${value}")
    endif()
  endforeach()
  rung_unity(${target}_plain)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  foreach(library ${libraries})
    rung_plain_of(${library} twin)
    target_link_libraries(${target}_plain PUBLIC ${twin})
  endforeach()
endfunction()
