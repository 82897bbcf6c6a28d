// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/client_input.hpp"

namespace rung::cli {
namespace {

constexpr int kReleaseAll = 7;  // command register

struct Wanted {
  std::string argument;
  std::string name;
  int address = 0;
  std::optional<bool> value;  // nothing: release
};

std::string label(const io::Subject& names, Device device) {
  for (const io::SubjectDevice& each : names.devices) {
    if (each.device != device) continue;
    return each.comment.empty() ? each.name : each.name + " " + each.comment;
  }
  return names.name(device);
}

void refuse(const std::string& argument, const std::string& what, std::string mend,
            Diagnostics& diagnostics) {
  diagnostics.error(argument, {}, what, std::move(mend));
}

// X5=1
Wanted parse(const std::string& argument) {
  const std::size_t equals = argument.rfind('=');
  const std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
  if (value != "0" && value != "1" && value != "release") {
    throw UsageError(fmt::format("{}: write DEVICE=0, DEVICE=1 or DEVICE=release", argument));
  }
  Wanted wanted{argument, argument.substr(0, equals), 0, {}};
  if (value != "release") wanted.value = value == "1";
  return wanted;
}

// Finds its address; false, with an error, if it has none.
bool find(Wanted& wanted, const io::Subject& names, const std::string& config,
          Diagnostics& diagnostics) {
  const std::string& argument = wanted.argument;
  const auto device = names.find(wanted.name, false);
  if (!device) {
    const std::string near = names.near(wanted.name);
    refuse(
        argument, "this is neither a device nor a name that the program has",
        near.empty() ? "write X5=1; names need --program" : fmt::format("did you mean {}?", near),
        diagnostics);
    return false;
  }
  if (device->kind != DeviceKind::X && device->kind != DeviceKind::Y) {
    refuse(argument, "inputs (X) and outputs (Y) can be forced, and nothing else",
           "write to other devices with a Modbus client", diagnostics);
    return false;
  }
  const auto point = io::point_of(*device, names.dialect, config);
  if (!point) {
    refuse(argument, fmt::format("configuration {} has no address for this device", config),
           "see `rung export`", diagnostics);
    return false;
  }
  wanted.address = point->address;
  return true;
}

void print_forces(client::Controller& controller, const io::Subject& names) {
  const auto forces = controller.forces();
  if (forces.empty()) fmt::print("nothing is forced\n");
  for (const client::Force& each : forces) {
    auto device = io::device_at(io::Table::Coil, each.address, names.dialect, controller.config());
    if (!device) {
      device = io::device_at(io::Table::Discrete, each.address, names.dialect, controller.config());
    }
    fmt::print("{} = {}\n", device ? label(names, *device) : fmt::format("{:#06x}", each.address),
               each.value ? 1 : 0);
  }
}

}  // namespace

int force_command(const Options& options) {
  if (options.devices.empty() && !options.list && !options.release_all) {
    throw UsageError("force: say what: DEVICE=0|1|release, --list or --release-all");
  }
  std::vector<Wanted> all;
  for (const std::string& argument : options.devices) all.push_back(parse(argument));
  Diagnostics diagnostics;
  const auto names = names_for(options, options.program, diagnostics);
  if (!names) return report(diagnostics);
  return with_controller(options, diagnostics, [&] {
    client::Controller controller(line_of(options, std::nullopt));
    for (Wanted& wanted : all) find(wanted, *names, controller.config(), diagnostics);
    if (diagnostics.has_errors()) return kRefused;
    if (options.release_all) controller.command(kReleaseAll);
    for (const Wanted& wanted : all) {
      try {
        if (wanted.value) {
          controller.force(wanted.address, *wanted.value);
        } else {
          controller.release(wanted.address);
        }
      } catch (const client::ExceptionError& error) {
        constexpr int kNoSuchPoint = 2;
        throw client::ClientError(
            fmt::format("{}: {}", wanted.name, error.what()),
            error.code == kNoSuchPoint
                ? "the program that runs does not refresh it: an output needs a pin in the I/O map"
                : "at most 64 inputs and outputs can be forced: release some");
      }
    }
    if (options.list || !all.empty()) print_forces(controller, *names);
    return kDone;
  });
}

}  // namespace rung::cli
