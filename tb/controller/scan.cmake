# SPDX-License-Identifier: Apache-2.0
# unit_scan: all of the controller but its micro-sequencer and UART, driven through its bus, and its time base.
file(GLOB scan_sources CONFIGURE_DEPENDS
     ${RUNG_ROOT}/hdl/controller/*.v ${RUNG_ROOT}/hdl/flow/*.v ${RUNG_ROOT}/hdl/core/*.v
     ${RUNG_ROOT}/hdl/peripherals/*.v ${RUNG_ROOT}/hdl/*.v ${RUNG_ROOT}/hdl/boards/ladder_ports.v)
list(FILTER scan_sources EXCLUDE REGEX "controller/controller(_core)?\\.v$")

add_library(rung_scan_models STATIC)
target_compile_options(rung_scan_models PRIVATE ${RUNG_MODEL_OPTIONS})
# RUNG_RETIRE: the complement in a RAM word that is read and written in the same clock.
set(scan_arguments -Wall -Wno-PINMISSING -O3 --x-initial unique -DRUNG_RETIRE -GCLOCKS_PER_MS=40)
rung_mutated(rung_scan_models controller_bus scan_sources scan_arguments)
verilate(rung_scan_models
  SOURCES ${scan_sources}
  INCLUDE_DIRS ${RUNG_GENERATED} ${RUNG_ROOT}/hdl/core ${RUNG_ROOT}/hdl/flow
  TOP_MODULE controller_bus
  PREFIX Vcontroller_bus
  VERILATOR_ARGS ${scan_arguments})
set(time_sources ${RUNG_ROOT}/hdl/controller/time_base.v)
set(time_arguments -Wall -O3 --x-initial unique -GCLOCKS_PER_MS=5)
rung_mutated(rung_scan_models time_base time_sources time_arguments)
verilate(rung_scan_models
  SOURCES ${time_sources}
  TOP_MODULE time_base
  PREFIX Vtime_base
  VERILATOR_ARGS ${time_arguments})
get_target_property(scan_includes rung_scan_models INCLUDE_DIRECTORIES)
set_target_properties(rung_scan_models PROPERTIES
                      INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${scan_includes}")

file(GLOB scan_tests CONFIGURE_DEPENDS scan_*.cpp)
add_executable(unit_scan ${scan_tests})
# Millions of clocks.
target_compile_options(unit_scan PRIVATE -O1)
target_link_libraries(unit_scan PRIVATE rung_scan_models rung_driver rung_melsec rung_reference
                      GTest::gtest_main)
target_include_directories(unit_scan PRIVATE ${RUNG_ROOT}/tb)
target_compile_definitions(unit_scan PRIVATE RUNG_REPOSITORY="${RUNG_ROOT}")
gtest_discover_tests(unit_scan NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60)
