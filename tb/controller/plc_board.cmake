# SPDX-License-Identifier: Apache-2.0
# unit_plc_board: the controller's board top of the HX8K through its pins.
add_library(rung_plc_board_model STATIC)
target_compile_options(rung_plc_board_model PRIVATE ${RUNG_MODEL_OPTIONS})
verilate(rung_plc_board_model
  SOURCES ${RUNG_ROOT}/hdl/boards/plc_hx8k.v ${RUNG_ROOT}/hdl/boards/power_on_reset.v ${controller_sources}
  INCLUDE_DIRS ${RUNG_GENERATED} ${RUNG_ROOT}/hdl/core ${RUNG_ROOT}/hdl/controller ${RUNG_ROOT}/hdl/flow
  TOP_MODULE plc_hx8k
  PREFIX Vplc_hx8k
  VERILATOR_ARGS -Wall -O3 --x-initial unique --noassert)
get_target_property(plc_board_includes rung_plc_board_model INCLUDE_DIRECTORIES)
set_target_properties(rung_plc_board_model PROPERTIES
                      INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${plc_board_includes}")

add_executable(unit_plc_board plc_board_test.cpp)
# Millions of clocks.
target_compile_options(unit_plc_board PRIVATE -O1)
target_link_libraries(unit_plc_board PRIVATE rung_plc_board_model rung_flash_model rung_device rung_driver
                      rung_melsec rung_ldmicro rung_load GTest::gtest_main)
target_include_directories(unit_plc_board PRIVATE ${RUNG_ROOT}/tb)
gtest_discover_tests(unit_plc_board DISCOVERY_TIMEOUT 60)
