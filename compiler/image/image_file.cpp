// SPDX-License-Identifier: Apache-2.0
#include "image/image_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "image/flow_file.hpp"
#include "image/wide_file.hpp"

namespace rung::image {
namespace {

using nlohmann::json;

constexpr std::string_view kMagic = "RUNGIMG";
constexpr std::size_t kHeader = kMagic.size() + 1 + 4 + 4;

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  return bytes;
}

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return value;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

json to_json(const Image& image) {
  const isa::Config& config = *isa::find_config(image.config);
  json out;
  out["program"] = image.program;
  out["dialect"] = image.dialect;
  out["mpu"] = static_cast<int>(image.mpu);
  out["paper"] = image.paper;
  out["config"] = image.config;
  out["lut"] = image.lut;
  out["clocks"] = image.clocks;
  out["ports"] = {image.port_bits, image.port_words};
  out["cycle_us"] = image.cycle_us;
  out["baud"] = image.baud;
  out["uses"] = {image.uart, image.pwm, image.own_pins};
  out["persist"] = image.persist;
  out["first_hidden"] = {image.first_hidden_bit, image.first_hidden_word};
  json steps = json::array();
  for (const auto& step : image.steps) {
    json words = json::array();
    for (const auto& slot : step) words.push_back(isa::encode(slot, image.mpu, config));
    steps.push_back(std::move(words));
  }
  out["steps"] = std::move(steps);
  out["origins"] = image.origins;
  out["quiet"] = image.quiet;
  json ticks = json::array();
  for (const ImageTicks& each : image.ticks) ticks.push_back({each.address, each.base_us});
  out["ticks"] = std::move(ticks);
  json constants = json::array();
  for (const ImageConstant& each : image.constants) constants.push_back({each.address, each.value});
  out["constants"] = std::move(constants);
  json devices = json::array();
  for (const ImageDevice& device : image.devices) {
    devices.push_back({device.name, static_cast<int>(device.device.kind), device.device.number,
                       device.address, device.comment});
  }
  out["devices"] = std::move(devices);
  json source = json::array();
  for (const SourceLine& line : image.source) {
    source.push_back({line.position.line, line.position.column, line.text});
  }
  out["source"] = std::move(source);
  const Statistics& s = image.statistics;
  out["statistics"] = {s.rungs,   s.instructions, s.contacts,    s.runs,
                       s.lookups, s.lut_rows,     s.bit_devices, s.word_devices};
  if (image.flow) out["flow"] = flow_to_json(*image.flow);
  if (image.wide) out["wide"] = wide_to_json(*image.wide);
  return out;
}

using file::inside;
using file::require;

// Everything that the processor and the tools index by is checked here, once.
void check(const Image& image, const isa::Config& config) {
  require((image.mpu == isa::Mpu::Mpu4) == image.wide.has_value(), "processor");
  if (image.wide) return check_wide(image);
  require(static_cast<int>(image.steps.size()) <= config.steps(image.mpu), "number of steps");
  require(image.lut.size() <= isa::constant::lut_rows, "number of LUT rows");
  require(image.origins.size() == image.steps.size(), "origins");
  require(image.quiet.size() == image.steps.size(), "quiet writes");
  for (std::size_t step = 0; step < image.steps.size(); ++step) {
    require(static_cast<int>(image.steps[step].size()) == isa::slots(image.mpu), "slots of a step");
    require(image.origins[step].size() == image.steps[step].size(), "origins of a step");
    require(image.quiet[step].size() == image.steps[step].size(), "quiet writes of a step");
    for (const int origin : image.origins[step]) {
      require(origin >= -1 && origin < static_cast<int>(image.source.size()), "origin");
    }
    for (const auto& slot : image.steps[step]) {
      require(!mapping::is_lookup(slot.opcode) || slot.row < image.lut.size(), "LUT row");
    }
  }
  for (const ImageDevice& device : image.devices) {
    const int size = is_word(device.device) ? config.word_devices : config.bit_devices;
    require(inside(device.address, size), "device address");
  }
  for (const ImageTicks& each : image.ticks) {
    require(inside(each.address, config.word_devices), "address of ticks");
    require(each.base_us > 0, "base of ticks");
  }
  require(image.port_bits >= 0 && image.port_bits <= config.bit_devices, "port bits");
  require(image.port_words >= 0 && image.port_words <= config.word_devices, "port words");
  require(image.cycle_us >= 0 && image.baud >= 0, "cycle");
  for (const ImageConstant& each : image.constants) {
    require(inside(each.address, config.word_devices), "address of a constant");
  }
  const Statistics& s = image.statistics;
  require(image.first_hidden_bit >= 0 && s.bit_devices <= config.bit_devices, "bit devices");
  require(image.first_hidden_word >= 0 && s.word_devices <= config.word_devices, "word devices");
}

// All numbers are whole: a fraction may be beyond what an integer holds.
void require_whole_numbers(const json& in) {
  std::vector<const json*> open{&in};
  while (!open.empty()) {
    const json& now = *open.back();
    open.pop_back();
    require(!now.is_number_float(), "number");
    if (!now.is_structured()) continue;
    for (const json& each : now) open.push_back(&each);
  }
}

Image from_json(const json& in) {
  require_whole_numbers(in);
  Image image;
  image.program = in.at("program").get<std::string>();
  image.dialect = in.at("dialect").get<std::string>();
  require(find_dialect(image.dialect).has_value(), "dialect");
  const int mpu = in.at("mpu").get<int>();
  require(mpu >= 1 && mpu <= 4, "processor");
  image.mpu = static_cast<isa::Mpu>(mpu);
  image.paper = in.at("paper").get<bool>();
  image.config = in.at("config").get<std::string>();
  const isa::Config* config = isa::find_config(image.config);
  require(config != nullptr, "configuration");
  image.lut = in.at("lut").get<std::vector<std::uint8_t>>();
  image.clocks = in.at("clocks").get<std::int64_t>();
  image.port_bits = in.at("ports").at(0).get<int>();
  image.port_words = in.at("ports").at(1).get<int>();
  image.cycle_us = in.at("cycle_us").get<std::int64_t>();
  image.baud = in.at("baud").get<std::int64_t>();
  const json& uses = in.at("uses");
  image.uart = uses.at(0).get<bool>();
  image.pwm = uses.at(1).get<bool>();
  image.own_pins = uses.at(2).get<bool>();
  image.persist = in.at("persist").get<std::vector<std::string>>();
  image.first_hidden_bit = in.at("first_hidden").at(0).get<int>();
  image.first_hidden_word = in.at("first_hidden").at(1).get<int>();
  for (const json& words : in.at("steps")) {
    auto& step = image.steps.emplace_back();
    for (const json& word : words) {
      const auto decoded = isa::decode(word.get<std::uint64_t>(), image.mpu, *config);
      require(decoded.has_value(), "instruction");
      step.push_back(*decoded);
    }
  }
  image.origins = in.at("origins").get<std::vector<std::vector<int>>>();
  for (const json& device : in.at("devices")) {
    const int kind = device.at(1).get<int>();
    require(inside(kind, kDeviceKinds), "kind of a device");
    image.devices.push_back({device.at(0).get<std::string>(),
                             {static_cast<DeviceKind>(kind), device.at(2).get<std::uint32_t>()},
                             device.at(3).get<int>(),
                             device.at(4).get<std::string>()});
  }
  image.quiet = in.at("quiet").get<std::vector<std::vector<std::uint8_t>>>();
  for (const json& each : in.at("ticks")) {
    image.ticks.push_back({each.at(0).get<int>(), each.at(1).get<std::int64_t>()});
  }
  for (const json& each : in.at("constants")) {
    image.constants.push_back({each.at(0).get<int>(), each.at(1).get<std::int16_t>()});
  }
  for (const json& line : in.at("source")) {
    image.source.push_back(
        {{line.at(0).get<int>(), line.at(1).get<int>()}, line.at(2).get<std::string>()});
  }
  const json& s = in.at("statistics");
  image.statistics = {s.at(0).get<int>(), s.at(1).get<int>(), s.at(2).get<int>(),
                      s.at(3).get<int>(), s.at(4).get<int>(), s.at(5).get<int>(),
                      s.at(6).get<int>(), s.at(7).get<int>()};
  if (in.contains("flow")) image.flow = flow_from_json(in.at("flow"));
  if (in.contains("wide")) image.wide = wide_from_json(in.at("wide"));
  check(image, *config);
  if (image.flow) check_flow(image, *config);
  return image;
}

std::uint8_t version_of(const Image& image) {
  if (image.wide) return kWideVersion;
  return image.flow ? kFlowVersion : kPlainVersion;
}

}  // namespace

bool is_image(std::string_view bytes) { return bytes.substr(0, kMagic.size()) == kMagic; }

std::string to_bytes(const Image& image) {
  const std::vector<std::uint8_t> cbor = json::to_cbor(to_json(image));
  const std::string payload(cbor.begin(), cbor.end());
  std::string bytes(kMagic);
  bytes += static_cast<char>(version_of(image));
  bytes += little_endian(static_cast<std::uint32_t>(payload.size()));
  bytes += little_endian(checksum(payload));
  return bytes + payload;
}

std::optional<Image> from_bytes(std::string_view bytes, const std::string& file,
                                Diagnostics& diagnostics) {
  const auto refuse = [&](std::string what) {
    diagnostics.error(file, {}, std::move(what), "compile the program again");
    return std::nullopt;
  };
  if (!is_image(bytes)) return refuse("this is not an image");
  if (bytes.size() < kHeader) return refuse("the image is cut short: its header is not whole");
  const auto version = static_cast<std::uint8_t>(bytes[kMagic.size()]);
  if (version < kPlainVersion || version > kWideVersion) {
    return refuse(
        fmt::format("the image has format version {}; this program reads versions {} to {}",
                    version, kPlainVersion, kWideVersion));
  }
  const std::uint32_t length = little_endian(bytes.substr(kMagic.size() + 1, 4));
  const std::uint32_t crc = little_endian(bytes.substr(kMagic.size() + 5, 4));
  const std::string_view payload = bytes.substr(kHeader);
  if (payload.size() != length) {
    return refuse(
        fmt::format("the image is damaged: {} bytes where it says {}", payload.size(), length));
  }
  if (checksum(payload) != crc) return refuse("the image is damaged: its CRC does not match");
  try {
    Image image = from_json(json::from_cbor(payload.begin(), payload.end()));
    require(version_of(image) == version, "processor, flow tasks and the version");
    return image;
  } catch (const std::exception& problem) {
    return refuse(fmt::format("the image holds what this program cannot use: {}", problem.what()));
  }
}

}  // namespace rung::image
