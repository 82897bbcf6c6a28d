# SPDX-License-Identifier: Apache-2.0
# The front door: every command of the project is a target here; `make help` lists them.
# Everything built goes under build/, logs to build/logs/.

.DEFAULT_GOAL := help
SHELL := /bin/bash
.SHELLFLAGS := -o pipefail -ec
.DELETE_ON_ERROR:

MPU     ?= 1 2 3
BOARD   ?= ulx3s hx8k
# Boards of the controller: all of them unless BOARD is given
PLC_BOARD := $(if $(filter file,$(origin BOARD)),ulx3s hx8k tangnano20k,$(BOARD))
SEEDS   ?= 1 2 3 4 5
CONFIG  ?= ecp5
PROGRAM ?=
JOBS    ?= 2
SECONDS ?= 600
MINUTES ?= 60
SCANS   ?=
COUNT   ?= 2000
# Of `make test-gate`, with a semicolon between two: hx8k-mpu1;ecp5-mpu2. Without it all
NETLISTS ?=

# What `make build` builds, into build/bin
PROGRAMS := rung rung-samples
RELEASE := -DCMAKE_BUILD_TYPE=Release -DCMAKE_RUNTIME_OUTPUT_DIRECTORY=$(CURDIR)/build/bin

# Compiled Python too goes under build/
export PYTHONPYCACHEPREFIX := $(CURDIR)/build/pycache

CMAKE   ?= cmake
CTEST   ?= ctest
PYTHON  ?= python3
VENV    := build/venv/bin
FLOW    := --mpu $(MPU) --board $(BOARD)

.PHONY: help
help: ## this list
	@echo 'make TARGET [NAME=VALUE ...]'
	@grep -E '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | \
	  awk -F ':.*## ' '{ printf "  %-12s %s\n", $$1, $$2 }'
	@echo 'Values (defaults): MPU="$(MPU)" BOARD="$(BOARD)" SEEDS="$(SEEDS)" CONFIG=$(CONFIG) JOBS=$(JOBS)'

# One CMake build directory: configure if needed, then build.
# $(1) directory, $(2) options of configuring, $(3) of building
define cmake_build
	@mkdir -p build/logs
	@# Old rules would run Verilator on a changed list of files before they renew themselves.
	@if find compiler tb -name CMakeLists.txt -newer $(1)/build.ninja 2>/dev/null | grep -q .; then \
	  rm $(1)/build.ninja; fi
	@test -f $(1)/build.ninja || { echo "configuring $(1)"; \
	  $(CMAKE) -G Ninja -S compiler -B $(1) $(2) >build/logs/$(notdir $(1))-configure.log 2>&1 || \
	  { tail -n 30 build/logs/$(notdir $(1))-configure.log; exit 1; }; }
	@# Verilator reads the generated header before CMake has a chance to renew it.
	@$(PYTHON) scripts/gen_isa.py $(1)/gen
	@echo "building $(1) (log: build/logs/$(notdir $(1))-build.log)"
	@NINJA_STATUS='[%f/%t] ' $(CMAKE) --build $(1) -j $(JOBS) $(3) 2>&1 | \
	  tee build/logs/$(notdir $(1))-build.log | scripts/progress.sh
endef

.PHONY: build
build: ## the rung program, build/bin/rung, and the generator of stand-in samples
	@scripts/setup.sh build
	$(call cmake_build,build/release,$(RELEASE),--target $(PROGRAMS))

.PHONY: sim
sim: build ## run a program on the three processors, checked against its golden trace; PROGRAM=, CONFIG=
	@$(PYTHON) scripts/sim.py $(if $(PROGRAM),--program $(PROGRAM)) --config $(CONFIG)

.PHONY: test
test: ## all tests, built with sanitizers
	@scripts/setup.sh test
	$(call cmake_build,build/test,-DCMAKE_BUILD_TYPE=RelWithDebInfo -DRUNG_SANITIZE=ON -DRUNG_UNITY=ON)
	@$(CTEST) --test-dir build/test -j $(JOBS) --output-on-failure --no-tests=error \
	  --output-log build/logs/test.log --output-junit results.xml

.PHONY: test-gate
test-gate: ## the golden traces on the synthesised netlists, ECP5 and iCE40: reports/gate-level.md; NETLISTS=
	@scripts/setup.sh build
	@scripts/setup.sh flow
	@$(VENV)/python scripts/gate_level.py netlists
	@$(CMAKE) -G Ninja -S compiler -B build/gate -DCMAKE_BUILD_TYPE=Release -DRUNG_GATE=$(CURDIR)/build/gate-netlists \
	  -DRUNG_YOSYS_CELLS=$$($(VENV)/python scripts/gate_level.py cells) "-DRUNG_GATE_ONLY=$(NETLISTS)" \
	  >build/logs/gate-configure.log
	$(call cmake_build,build/gate,,--target gate_golden gate_faults)
	@$(VENV)/python scripts/gate_level.py run

.PHONY: cov
cov: ## what the tests reach of pipeline, hardware and C++: reports/coverage.md; COUNT= random programs
	@scripts/setup.sh cov
	$(call cmake_build,build/release,$(RELEASE),--target coverage_functional)
	$(call cmake_build,build/cov,-DRUNG_COVERAGE=ON -DRUNG_UNITY=ON,--target rung $$($(PYTHON) scripts/coverage.py targets))
	@$(PYTHON) scripts/coverage.py run --programs $(COUNT) --jobs $(JOBS)

.PHONY: reliability
reliability: ## the controller with damaged programs, wrong frames, power cuts: reports/reliability.md
	@scripts/setup.sh build
	$(call cmake_build,build/release,$(RELEASE),--target reliability)
	@$(PYTHON) scripts/reliability.py --jobs $(JOBS)

.PHONY: fuzz
fuzz: ## fuzz every reader of outside bytes, SECONDS= of a processor each: reports/fuzz.md, tb/fuzz/corpus
	@scripts/setup.sh fuzz
	$(call cmake_build,build/fuzz,-DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=clang++ \
	  -DCMAKE_C_COMPILER=clang -DRUNG_SANITIZE=ON -DRUNG_FUZZ=ON,--target fuzzers)
	@$(PYTHON) scripts/fuzz.py --seconds $(SECONDS) --jobs $(JOBS)

.PHONY: soak
soak: ## the controller under load with faults, 10 million scans in all: adds to reports/soak.md; SCANS= MINUTES=
	@scripts/setup.sh build
	$(call cmake_build,build/release,$(RELEASE),--target rung-soak)
	@$(PYTHON) scripts/soak.py --jobs $(JOBS) $(if $(SCANS),--scans $(SCANS)) \
	  $(if $(filter command line,$(origin MINUTES)),--minutes $(MINUTES))

.PHONY: lint
lint: ## Verilator -Wall, verible, pins of the boards, clang-format, the instruction set page
	@scripts/setup.sh lint
	@$(VENV)/python scripts/lint.py

.PHONY: isa
isa: ## rewrite hdl/isa/README.md from the tables beside it
	@scripts/setup.sh build
	@$(PYTHON) scripts/gen_isa.py --page hdl/isa/README.md

.PHONY: synth
synth: ## netlists of the processors in their board tops; MPU= BOARD=
	@scripts/setup.sh flow
	@$(VENV)/python scripts/synth.py $(FLOW)

.PHONY: pnr
pnr: ## place and route: area and clock, into reports/ if all of them run; MPU= BOARD= SEEDS=
	@scripts/setup.sh flow
	@$(VENV)/python scripts/pnr.py $(FLOW) --seeds $(SEEDS) --jobs $(JOBS)
	@if [ -e reports/area-timing.json ]; then $(PYTHON) scripts/report_area.py; fi

pnr-wide: build ## place and route MPU4 with 4, 8 and 16 slots, an hour or two: reports/wide-timing.md; SEEDS=
	@scripts/setup.sh flow
	@$(VENV)/python scripts/pnr_wide.py --seeds $(SEEDS)

.PHONY: bit
bit: ## bitstreams of the controller: build/bit; BOARD=ulx3s, hx8k or tangnano20k, without it all
	@scripts/setup.sh flow
	@$(VENV)/python scripts/bit.py --board $(PLC_BOARD) --seeds $(SEEDS)

.PHONY: prog
prog: ## load a board's flash with its bitstream; BOARD=, PROG=--sram (until power is off), --dry-run
	@if [ $(words $(PLC_BOARD)) != 1 ]; then \
	  echo 'which board? make prog BOARD=ulx3s, hx8k or tangnano20k' >&2; exit 2; fi
	@scripts/setup.sh prog
	@$(MAKE) --no-print-directory bit
	@$(VENV)/python scripts/prog.py --board $(PLC_BOARD) $(PROG)

.PHONY: boards
boards: ## the controller on its boards: area and clock over seeds 1 to 3: reports/boards.md
	@scripts/setup.sh flow
	@$(VENV)/python scripts/boards.py --jobs $(JOBS)

.PHONY: bench
bench: build ## scan times of the samples beside soft cores and this machine, into reports/
	@scripts/setup.sh bench
	@$(VENV)/python scripts/yardsticks.py --jobs $(JOBS)
	@$(VENV)/python scripts/report_area.py
	@$(PYTHON) scripts/headline.py

.PHONY: explore
explore: build ## steps of other wide processors than there are: reports/explore.md
	$(call cmake_build,build/release,$(RELEASE),--target rung-explore)
	@build/bin/rung-explore $$(date +%F) >build/explore.md
	@mv build/explore.md reports/explore.md
	@echo 'wrote reports/explore.md'

.PHONY: steps
steps: build ## the paper's tables reproduced: reports/steps.md
	$(call cmake_build,build/release,$(RELEASE),--target rung-steps)
	@build/bin/rung-steps $$(date +%F) >build/steps.md
	@mv build/steps.md reports/steps.md
	@echo 'wrote reports/steps.md'

.PHONY: plant
plant: ## an hour of plant time of the controller, beside the reference and a client: reports/plant.md; MINUTES=
	@scripts/setup.sh build
	$(call cmake_build,build/release,$(RELEASE),--target rung-plant)
	@build/bin/rung-plant $(MINUTES) $$(date +%F) >build/plant.md
	@mv build/plant.md reports/plant.md
	@echo 'wrote reports/plant.md'

.PHONY: flow-report
flow-report: ## the paper's experiment with 1 to 100 flow tasks: reports/flow.md
	@scripts/setup.sh test
	$(call cmake_build,build/release,$(RELEASE),--target rung-flow)
	@build/bin/rung-flow $$(date +%F) build/flow.md build/flow.json --jobs $(JOBS)
	@$(PYTHON) scripts/flow_cost.py build/flow.md build/flow.json
	@mv build/flow.md build/flow.json reports/
	@echo 'wrote reports/flow.md and flow.json'

.PHONY: programs
programs: build ## real lists and LDmicro programs: which run, what each instruction costs: reports/programs.md
	@$(PYTHON) scripts/programs_report.py

.PHONY: formal
formal: ## prove what tb/formal/*.toml list, with faults that the proofs refuse: reports/formal.md
	@scripts/setup.sh flow
	@$(VENV)/python scripts/formal.py --jobs $(JOBS)

.PHONY: mutate
mutate: ## faults in processors and controller that the tests have to notice: reports/mutation.md; SECONDS= a netlist
	@scripts/setup.sh build
	@scripts/setup.sh flow
	@$(VENV)/python scripts/mutate.py --jobs $(JOBS) $(if $(filter command,$(firstword $(origin SECONDS))),--seconds $(SECONDS))

.PHONY: verification
verification: test ## each promise of the design with its evidence, from the tests and reports: reports/verification.md
	@$(PYTHON) scripts/verification.py

.PHONY: hardwired
hardwired: build ## programs as hard-wired logic: checked, area, clock, time of a change: reports/hardwired.md
	@scripts/setup.sh flow
	$(call cmake_build,build/release,$(RELEASE),--target hardwired_all)
	@build/release/tb/hardwired/hardwired_all
	@$(VENV)/python scripts/hardwired.py --jobs $(JOBS)

.PHONY: cells
cells: build ## the processors on standard cells: gates, area, clock: reports/cells.md
	@scripts/setup.sh cells
	@$(VENV)/python scripts/cells.py

.PHONY: tradeoff
tradeoff: build ## all of it on one chart, from the other reports: reports/tradeoff.md
	@scripts/setup.sh chart
	@build/chart/bin/python scripts/tradeoff.py

.PHONY: report
report: ## all reports, in order: steps, programs, area and clock, boards, bench; then reports/index.html
	@scripts/setup.sh bench
	@$(MAKE) --no-print-directory steps
	@$(MAKE) --no-print-directory programs
	@$(MAKE) --no-print-directory pnr
	@$(MAKE) --no-print-directory boards
	@$(MAKE) --no-print-directory bench
	@$(MAKE) --no-print-directory report-page

.PHONY: report-page
report-page: ## reports/index.html from the JSON that the other targets have written: plots and tables
	@$(PYTHON) scripts/report_page.py

.PHONY: pictures
pictures: build ## the pictures of rung view that README.md shows: reports/view-*.png
	@scripts/setup.sh test
	@RUNG=build/bin/rung RUNG_BROWSER=$(CURDIR)/build/browser node tb/view/pictures.mjs reports

.PHONY: clean
clean: ## remove everything built but what was downloaded: build/venv, clients, browser and chart
	@if [ -d build ]; then find build -mindepth 1 -maxdepth 1 \
	  ! -name venv ! -name clients ! -name browser ! -name chart -exec rm -rf {} +; fi
