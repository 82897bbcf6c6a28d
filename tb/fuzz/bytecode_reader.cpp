// SPDX-License-Identifier: Apache-2.0
#include "fuzz/bytecode_reader.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "bytecode/interpreter/rung_vm.h"
#include "fuzz/require.hpp"

namespace rung::fuzz {
namespace {

using File = std::vector<std::uint8_t>;

constexpr int kScans = 3;
constexpr std::uint32_t kElapsed[kScans] = {0, 10000, UINT32_MAX};

// Every name leads to a device that can be read and written.
void use_names(rung_vm& vm) {
  char name[16];
  rung_vm_device device = {};
  for (std::uint16_t i = 0; rung_vm_name(&vm, i, name, sizeof name, &device) != 0; ++i) {
    static_cast<void>(rung_vm_find(&vm, name, &device));
    rung_vm_set_value(&vm, device, static_cast<std::int16_t>(i * 257));
    require(rung_vm_value(&vm, device) ==
                (device.space == RUNG_SPACE_BIT ? i != 0 : static_cast<std::int16_t>(i * 257)),
            "a device that does not keep its value");
  }
  for (int port = 0; port < 256; ++port) {
    for (const std::uint8_t space : {RUNG_SPACE_BIT, RUNG_SPACE_WORD}) {
      if (rung_vm_port(&vm, space, static_cast<std::uint8_t>(port), &device) != 0) {
        rung_vm_set_value(&vm, device, 1);
      }
    }
  }
}

void run(const File& file) {
  rung_vm_memory memory = {};
  if (rung_vm_needs(file.data(), file.size(), &memory) != RUNG_VM_OK) return;
  std::vector<std::uint32_t> times(memory.times_count);
  std::vector<std::uint16_t> words(memory.words_count);
  std::vector<std::uint8_t> bits(memory.bits_count);
  memory.times = times.data();
  memory.words = words.data();
  memory.bits = bits.data();
  rung_vm vm;
  require(rung_vm_load(&vm, file.data(), file.size(), &memory) == RUNG_VM_OK,
          "accepted, and then refused with the memory it asked for");
  const File constants(reinterpret_cast<const std::uint8_t*>(words.data() + vm.first_constant),
                       reinterpret_cast<const std::uint8_t*>(words.data() + words.size()));
  for (const std::uint32_t elapsed : kElapsed) {
    rung_vm_scan(&vm, elapsed);
    use_names(vm);
  }
  require(std::equal(constants.begin(), constants.end(),
                     reinterpret_cast<const std::uint8_t*>(words.data() + vm.first_constant)),
          "a constant has changed");
  require(std::all_of(bits.begin(), bits.end(), [](std::uint8_t bit) { return bit <= 1; }),
          "a bit that is neither 0 nor 1");
}

void put(File& file, std::size_t at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) file[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

}  // namespace

void read_bytecode(std::string_view bytes) {
  File file(bytes.begin(), bytes.end());
  run(file);
  if (file.size() < RUNG_HEADER_BYTES + RUNG_CRC_BYTES) return;
  std::copy_n(RUNG_FORMAT_MAGIC, 4, file.begin());
  file[RUNG_AT_MAJOR] = RUNG_FORMAT_MAJOR;
  file[RUNG_AT_MINOR] = RUNG_FORMAT_MINOR;
  put(file, RUNG_AT_SIZE, static_cast<std::uint32_t>(file.size()));
  const std::size_t end = file.size() - RUNG_CRC_BYTES;
  put(file, end, static_cast<std::uint32_t>(crc32(0, file.data(), static_cast<uInt>(end))));
  run(file);
}

}  // namespace rung::fuzz
