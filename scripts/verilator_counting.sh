#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Verilator with counters of lines, branches and toggles in each model: VERILATOR_BIN of `make cov`.
exec verilator_bin --coverage-line --coverage-toggle "$@"
