# SPDX-License-Identifier: Apache-2.0
# cmake -DBATCH=... -DSET=... -DVERILATOR=... -DFOLDER=... -DPARTS=... -P verilate.cmake
# The Verilog of a set of programs, and its model in PARTS C++ files: how many Verilator writes is
# not known before, and each of its own would read the headers again.
set(model Vhardwired_${SET})
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${BATCH} ${SET} ${FOLDER}/batch.v COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${VERILATOR} --cc -Wall -Wno-DECLFILENAME -O3 --x-initial unique --x-assign fast
          --prefix ${model} --top-module hardwired_batch --Mdir ${FOLDER} ${FOLDER}/batch.v
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB sources ${FOLDER}/${model}*.cpp)
list(SORT sources)
set(number 0)
foreach(source ${sources})
  string(APPEND part${number} "#include \"${source}\"\n")
  math(EXPR number "(${number} + 1) % ${PARTS}")
endforeach()
math(EXPR last "${PARTS} - 1")
foreach(number RANGE ${last})
  file(WRITE ${FOLDER}/part${number}.cpp "${part${number}}")
endforeach()
