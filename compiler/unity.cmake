# SPDX-License-Identifier: Apache-2.0
# rung_unity(TARGET): its sources are compiled as one. Headers and their templates are most of what is
# compiled, and are then read once: it takes some 60 % of the time. But a change compiles them all.
function(rung_unity target)
  if(target MATCHES "^(rung_lower|rung_lower_plain|unit_rtl|unit_compiler)$")
    return()  # most of their sources have names alike
  elseif(target MATCHES "_models?$|^rung_view_processor$")
    return()  # each has Verilator's own sources, of which a program wants one
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
endfunction()

# Sources that have names of their own which another source of their target has too: add to them what
# the compiler calls redefined or ambiguous.
set(RUNG_ALONE
    compiler/source/write_file compiler/image/frame compiler/trace/read_trace compiler/load/load_file
    compiler/melsec/unsupported compiler/reference/ldmicro_timers
    compiler/flowchart/logic tb/agree/ldmicro_case tb/programs/ldmicro_elements
    tb/programs/ldmicro_stimulus tb/programs/melsec_operands tb/programs/melsec_stimulus
    tb/programs/random_ldmicro tb/programs/random_melsec tb/programs/shrink_ldmicro
    compiler/cli/device_command tb/device/line_test tb/firmware/native tb/flow_units/probe tb/flow_units/outside
    tb/flowchart/refused_header_test tb/flowchart/refused_step_test tb/fuzz/bytecode_reader tb/fuzz/line_readers
    tb/fuzz/link_reader tb/fuzz/firmware_readers tb/fuzz/controller_reader
    tb/passes/wide_image_test tb/wide_rtl/random_test)
list(TRANSFORM RUNG_ALONE PREPEND ${RUNG_ROOT}/)
list(TRANSFORM RUNG_ALONE APPEND .cpp)
function(rung_alone folder)
  set_source_files_properties(${RUNG_ALONE} DIRECTORY ${folder} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# rung_unity_of(FOLDER): all targets made in it, and in what it has added.
function(rung_unity_of folder)
  get_directory_property(targets DIRECTORY ${folder} BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(type MATCHES "STATIC_LIBRARY|EXECUTABLE")
      rung_unity(${target})
    endif()
  endforeach()
  rung_alone(${folder})
  get_directory_property(added DIRECTORY ${folder} SUBDIRECTORIES)
  foreach(each ${added})
    rung_unity_of(${each})
  endforeach()
endfunction()
