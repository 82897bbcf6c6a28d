# SPDX-License-Identifier: Apache-2.0
# rung_controller_models: the controller of two boards, Verilated for speed and without sanitizers, built
# once for `rung device` and the tests; each of them alone is rung_controller_NAME_model. rung_simulated_controller: the bench around it.
set(RUNG_CLOCKS_PER_MS 250)  # of a simulated millisecond
file(GLOB controller_sources CONFIGURE_DEPENDS
  ${RUNG_ROOT}/hdl/controller/*.v ${RUNG_ROOT}/hdl/controller/micro/*.v
  ${RUNG_ROOT}/hdl/flow/*.v ${RUNG_ROOT}/hdl/core/*.v ${RUNG_ROOT}/hdl/peripherals/*.v ${RUNG_ROOT}/hdl/*.v)
list(APPEND controller_sources ${RUNG_ROOT}/hdl/boards/ladder_ports.v)

add_library(rung_controller_models INTERFACE)
# Each with its UART, and once more with bytes in the place of it.
set(controller_byte_sources ${controller_sources})
list(FILTER controller_byte_sources EXCLUDE REGEX "/host_uart\\.v$")
list(APPEND controller_byte_sources ${CMAKE_CURRENT_SOURCE_DIR}/bytes/host_uart.v)
foreach(board simulated:0:${RUNG_CLOCKS_PER_MS} hx8k:2:${RUNG_CLOCKS_PER_MS}
              simulated_bytes:0:${RUNG_CLOCKS_PER_MS} hx8k_bytes:2:${RUNG_CLOCKS_PER_MS}
              plant_bytes:0:${RUNG_PLANT_CLOCKS_PER_MS})
  string(REPLACE ":" ";" board ${board})
  list(GET board 0 name)
  list(GET board 1 number)
  list(GET board 2 clocks_per_ms)
  set(model_sources ${controller_sources})
  if(name MATCHES "_bytes$")
    set(model_sources ${controller_byte_sources})
  endif()
  set(model rung_controller_${name}_model)
  add_library(${model} STATIC)
  target_compile_options(${model} PRIVATE ${RUNG_MODEL_OPTIONS})
  verilate(${model}
    SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/simulated_controller.v ${model_sources}
    INCLUDE_DIRS ${RUNG_GENERATED} ${RUNG_ROOT}/hdl/core ${RUNG_ROOT}/hdl/controller ${RUNG_ROOT}/hdl/flow
    TOP_MODULE simulated_controller
    PREFIX Vcontroller_${name}
    VERILATOR_ARGS -Wall -O3 --x-initial unique --x-assign fast --noassert
                   -GBOARD=${number} -GCLOCKS_PER_MS=${clocks_per_ms})
  get_target_property(controller_includes ${model} INCLUDE_DIRECTORIES)
  set_target_properties(${model} PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${controller_includes}")
  target_link_libraries(rung_controller_models INTERFACE ${model})
endforeach()

add_library(rung_simulated_controller STATIC simulated_controller.cpp)
target_link_libraries(rung_simulated_controller PUBLIC rung_device rung_controller_models
                      rung_flash_model)
target_include_directories(rung_simulated_controller PUBLIC ${RUNG_ROOT}/tb)
target_compile_definitions(rung_simulated_controller PRIVATE
                           RUNG_CLOCKS_PER_MS=${RUNG_CLOCKS_PER_MS}
                           RUNG_PLANT_CLOCKS_PER_MS=${RUNG_PLANT_CLOCKS_PER_MS})
# Its loop runs with every clock of every simulated hour: as fast in the tests as the model itself.
target_compile_options(rung_simulated_controller PRIVATE -O2 $<$<BOOL:${RUNG_SANITIZE}>:-fno-sanitize=all>)

add_executable(unit_simulated bit_line_test.cpp simulated_controller_test.cpp)
target_link_libraries(unit_simulated PRIVATE rung_simulated_controller GTest::gtest_main)
gtest_discover_tests(unit_simulated NO_PRETTY_VALUES TIMEOUT 120)
