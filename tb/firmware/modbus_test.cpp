// SPDX-License-Identifier: Apache-2.0
// Function codes, their exceptions and the order of the checks.
#include <algorithm>

#include "bench.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

std::uint16_t u16(int value) { return static_cast<std::uint16_t>(value); }

class Modbus : public Bench {
 protected:
  Modbus() { install(sample_program(0x55AA).words()); }

  int exception(const Bytes& request) {
    const Bytes out = ask(request);
    if (out.size() == 2 && out[0] == (request[0] | 0x80)) return out[1];
    EXPECT_TRUE(!out.empty() && out[0] == request[0]);
    return 0;
  }
  static Bytes with(Bytes pdu, const Bytes& more) {
    pdu.insert(pdu.end(), more.begin(), more.end());
    return pdu;
  }
  int coils = area("M").first, inputs = area("X").first, d = area("D").first;
};

TEST_F(Modbus, ReadsBits) {
  for (const int n : {0, 2, 3, 7}) machine_->bits[n] = 1;
  machine_->bits[1] = machine_->bits[4] = machine_->bits[5] = machine_->bits[6] = 0;
  machine_->bits[200] = 1;
  EXPECT_EQ(ask(pdu(1, {u16(coils), 8})), (Bytes{1, 1, 0x8D}));
  EXPECT_EQ(ask(pdu(2, {u16(coils), 10})), (Bytes{2, 2, 0x8D, 0}));
  EXPECT_EQ(ask(pdu(1, {u16(coils + 2), 3})), (Bytes{1, 1, 3}));
  EXPECT_EQ(ask(pdu(2, {u16(inputs), 1})), (Bytes{2, 1, 1}));
  EXPECT_EQ(exception(pdu(1, {u16(inputs), 1})), 2) << "inputs are no coils";
  // A device that the program does not have
  EXPECT_EQ(ask(pdu(1, {u16(coils + 20), 9})), (Bytes{1, 2, 0, 0}));
}

TEST_F(Modbus, ReadsAndWritesRegisters) {
  machine_->words[3] = 0x1234;
  EXPECT_EQ(ask(pdu(3, {u16(d + 3), 2})), (Bytes{3, 4, 0x12, 0x34, 0, 0}));
  EXPECT_EQ(ask(pdu(4, {u16(d + 3), 1})), (Bytes{4, 2, 0x12, 0x34}));
  EXPECT_EQ(ask(pdu(6, {u16(d + 1), 0xABCD})), pdu(6, {u16(d + 1), 0xABCD}));
  EXPECT_EQ(machine_->words[1], 0xABCD);
  EXPECT_EQ(write(d + 4, {1, 2, 3}), 0);
  EXPECT_EQ((Words{machine_->words.begin() + 4, machine_->words.begin() + 7}), (Words{1, 2, 3}));
  // 23: writes, then reads
  EXPECT_EQ(ask(with(pdu(23, {u16(d + 3), 2, u16(d + 4), 2}), {4, 0, 9, 0, 8})),
            (Bytes{23, 4, 0x12, 0x34, 0, 9}));
  EXPECT_EQ(machine_->words[5], 8);
  // 22
  machine_->words[0] = 0x12;
  EXPECT_EQ(ask(pdu(22, {u16(d), 0xF2, 0x25})), pdu(22, {u16(d), 0xF2, 0x25}));
  EXPECT_EQ(machine_->words[0], 0x17);
}

TEST_F(Modbus, WritesBits) {
  EXPECT_EQ(ask(pdu(5, {u16(coils + 1), 0xFF00})), pdu(5, {u16(coils + 1), 0xFF00}));
  EXPECT_EQ(machine_->bits[1], 1);
  EXPECT_EQ(exception(pdu(5, {u16(coils + 1), 0})), 0);
  EXPECT_EQ(machine_->bits[1], 0);
  EXPECT_EQ(ask(with(pdu(15, {u16(coils), 5}), {1, 0xF5})), pdu(15, {u16(coils), 5}));
  EXPECT_EQ((Words{machine_->bits.begin(), machine_->bits.begin() + 6}), (Words{1, 0, 1, 0, 1, 0}));
  EXPECT_EQ(exception(with(pdu(15, {u16(coils + 5), 10}), {2, 0xFF, 3})), 0);
  EXPECT_EQ(machine_->bits[7], 1);
  EXPECT_EQ(machine_->bits[8], 0);
  EXPECT_EQ(exception(pdu(5, {u16(inputs), 0})), 2);
  EXPECT_EQ(exception(with(pdu(15, {u16(inputs), 1}), {1, 1})), 2);
}

TEST_F(Modbus, EveryAreaBeginsAndEnds) {
  for (const auto& area : c::areas) {
    if (area.config != kConfig) continue;
    bool bits = false;
    for (const char* name : {"M", "M8", "S", "T", "C", "Y", "X", "L", "F", "B", "SM", "ST"})
      bits |= area.name == name;
    Words& map = bits ? machine_->bit_map : machine_->word_map;
    const std::uint16_t before = map[area.index + area.count - 1];
    map[area.index + area.count - 1] = 0x8000 | 150;
    (bits ? machine_->bits : machine_->words)[150] = 1;
    const int last = area.first + area.count - 1;
    const Bytes out = ask(pdu(bits ? 2 : 3, {u16(last), 1}));
    EXPECT_EQ(out, bits ? (Bytes{2, 1, 1}) : (Bytes{3, 2, 0, 1})) << area.name;
    map[area.index + area.count - 1] = before;
    bool touches = false;
    for (const auto& other : c::areas) {
      touches |= other.config == kConfig && other.first == last + 1 && &other == &area + 1;
    }
    EXPECT_EQ(exception(pdu(bits ? 2 : 3, {u16(last), 2})), touches ? 0 : 2) << area.name;
    EXPECT_EQ(exception(pdu(bits ? 2 : 3, {u16(last + 1), 1})), touches ? 0 : 2) << area.name;
  }
}

TEST_F(Modbus, AreasThatTouch) {
  if (kConfig != "ecp5") GTEST_SKIP() << "its areas do not";
  machine_->bit_map[7679] = 0x8000 | 50;
  machine_->bit_map[7680] = 0x8000 | 51;
  machine_->bits[50] = machine_->bits[51] = 1;
  EXPECT_EQ(ask(pdu(1, {7679, 2})), (Bytes{1, 1, 3}));
  EXPECT_EQ(exception(with(pdu(15, {7679, 2}), {1, 1})), 0);
  EXPECT_EQ(machine_->bits[51], 0);
  EXPECT_EQ(exception(pdu(1, {0x33F0, 32})), 2);  // Y to X: no coils
  EXPECT_EQ(exception(pdu(2, {0x33F0, 32})), 0);
}

TEST_F(Modbus, Quantities) {
  const auto read_bits = [&](int function, int count) {
    return exception(pdu(function, {u16(coils), u16(count)}));
  };
  for (const int function : {1, 2}) {
    EXPECT_EQ(read_bits(function, 0), 3);
    EXPECT_EQ(read_bits(function, 2001), 3);
    EXPECT_EQ(read_bits(function, 2000), area("M").count >= 2000 ? 0 : 2);
    EXPECT_EQ(read_bits(function, 512), 0);
    EXPECT_EQ(read_bits(function, 0xFFFF), 3);
  }
  for (const int function : {3, 4}) {
    EXPECT_EQ(exception(pdu(function, {u16(d), 0})), 3);
    EXPECT_EQ(exception(pdu(function, {u16(d), 126})), 3);
    EXPECT_EQ(exception(pdu(function, {u16(d), 125})), 0);
  }
  EXPECT_EQ(exception(with(with(pdu(15, {u16(coils), 1969}), {247}), Bytes(247))), 3);
  EXPECT_EQ(exception(with(with(pdu(15, {u16(coils), 1968}), {246}), Bytes(246))),
            area("M").count >= 1968 ? 0 : 2);
  EXPECT_EQ(exception(with(pdu(15, {u16(coils), 0}), {0})), 3);
  EXPECT_EQ(exception(with(pdu(15, {u16(coils), 9}), {1, 0})), 3);
  EXPECT_EQ(exception(with(pdu(15, {u16(coils), 8}), {2, 0, 0})), 3);
  EXPECT_EQ(exception(with(with(pdu(16, {u16(d), 123}), {246}), Bytes(246))), 0);
  EXPECT_EQ(exception(with(with(pdu(16, {u16(d), 124}), {248}), Bytes(246))), 3);
  EXPECT_EQ(exception(with(pdu(16, {u16(d), 0}), {0})), 3);
  EXPECT_EQ(exception(with(pdu(16, {u16(d), 1}), {3, 0, 0, 0})), 3);
  const auto both = [&](int read, int written, int bytes) {
    return exception(with(with(pdu(23, {u16(d), u16(read), u16(d), u16(written)}),
                               {static_cast<std::uint8_t>(bytes)}),
                          Bytes(std::min(bytes, 242))));
  };
  EXPECT_EQ(both(125, 121, 242), 0);
  EXPECT_EQ(both(126, 121, 242), 3);
  EXPECT_EQ(both(125, 122, 244), 3);
  EXPECT_EQ(both(0, 1, 2), 3);
  EXPECT_EQ(both(1, 0, 0), 3);
  EXPECT_EQ(both(1, 2, 2), 3);
  EXPECT_EQ(machine_->points_too_many, 0);
}

TEST_F(Modbus, QuantityComesBeforeAddress) {
  EXPECT_EQ(exception(pdu(1, {0xDFFF, 0})), 3);
  EXPECT_EQ(exception(pdu(3, {0xDFFF, 126})), 3);
  EXPECT_EQ(exception(pdu(5, {0xDFFF, 1})), 3);
  EXPECT_EQ(exception(pdu(5, {0xDFFF, 0xFF01})), 3);
  EXPECT_EQ(exception(pdu(5, {0xDFFF, 0xFF00})), 2);
  EXPECT_EQ(exception(pdu(6, {0xDFFF, 1})), 2);
  EXPECT_EQ(exception(pdu(22, {0xDFFF, 1, 1})), 2);
  EXPECT_EQ(exception(with(pdu(16, {0xDFFF, 1}), {2, 0, 0})), 2);
  EXPECT_EQ(exception(with(pdu(23, {u16(d), 1, 0xDFFF, 1}), {2, 0, 0})), 2);
  EXPECT_EQ(exception(with(pdu(23, {0xDFFF, 1, u16(d), 1}), {2, 0, 0})), 2);
  for (const int function : {1, 2, 3, 4}) EXPECT_EQ(exception(pdu(function, {0xFFFF, 2})), 2);
  EXPECT_EQ(exception(pdu(3, {0xFFFF, 1})), 2);
}

TEST_F(Modbus, LengthsOfRequests) {
  const std::vector<Bytes> right{pdu(1, {u16(coils), 1}),
                                 pdu(2, {u16(coils), 1}),
                                 pdu(3, {u16(d), 1}),
                                 pdu(4, {u16(d), 1}),
                                 pdu(5, {u16(coils), 0}),
                                 pdu(6, {u16(d), 0}),
                                 with(pdu(15, {u16(coils), 1}), {1, 0}),
                                 with(pdu(16, {u16(d), 1}), {2, 0, 0}),
                                 pdu(22, {u16(d), 0xFFFF, 0}),
                                 with(pdu(23, {u16(d), 1, u16(d), 1}), {2, 0, 0}),
                                 {43, 14, 1, 0}};
  const auto before = machine_->words;
  for (const Bytes& request : right) {
    EXPECT_EQ(exception(request), 0);
    EXPECT_EQ(exception(with(request, {0})), 3) << int(request[0]);
    for (std::size_t size = 1; size < request.size(); ++size) {
      EXPECT_EQ(exception(Bytes(request.begin(), request.begin() + static_cast<long>(size))), 3)
          << int(request[0]);
    }
  }
  EXPECT_EQ(machine_->words, before);
}

TEST_F(Modbus, OtherFunctions) {
  for (int function = 0; function < 256; ++function) {
    switch (function) {
      case 1:
      case 2:
      case 3:
      case 4:
      case 5:
      case 6:
      case 8:
      case 15:
      case 16:
      case 22:
      case 23:
      case 43:
        continue;
      default:
        break;
    }
    const Bytes out = ask(pdu(function, {0, 1}));
    EXPECT_EQ(out, (Bytes{static_cast<std::uint8_t>(function | 0x80), 1}));
  }
}

TEST_F(Modbus, LoopBack) {
  EXPECT_EQ(ask(pdu(8, {0, 0xA537})), pdu(8, {0, 0xA537}));
  EXPECT_EQ(ask(pdu(8, {0})), pdu(8, {0}));
  EXPECT_EQ(ask(pdu(8, Words(126))), pdu(8, Words(126)));
  EXPECT_EQ(exception(pdu(8, {1, 0})), 1);
  EXPECT_EQ(exception(pdu(8, {0x0100, 0})), 1);
  EXPECT_EQ(exception({8}), 3);
  EXPECT_EQ(exception({8, 0}), 3);
}

TEST_F(Modbus, Identification) {
  const auto object = [](std::uint8_t number, std::string_view text) {
    Bytes out{number, static_cast<std::uint8_t>(text.size())};
    out.insert(out.end(), text.begin(), text.end());
    return out;
  };
  const Bytes vendor = object(0, "Rung");
  const Bytes product = object(1, "board 0 mpu 3");
  const Bytes revision = object(2, "1");
  const Bytes all = with(with(vendor, product), revision);
  for (const std::uint8_t code : {1, 2, 3}) {
    EXPECT_EQ(ask({43, 14, code, 0}), with({43, 14, code, 0x81, 0, 0, 3}, all));
    EXPECT_EQ(ask({43, 14, code, 7}), with({43, 14, code, 0x81, 0, 0, 3}, all))
        << "unknown: from the first on";
    EXPECT_EQ(ask({43, 14, code, 1}), with({43, 14, code, 0x81, 0, 0, 2}, with(product, revision)));
  }
  EXPECT_EQ(ask({43, 14, 4, 1}), with({43, 14, 4, 0x81, 0, 0, 1}, product));
  EXPECT_EQ(ask({43, 14, 4, 2}), with({43, 14, 4, 0x81, 0, 0, 1}, revision));
  EXPECT_EQ(exception({43, 14, 4, 3}), 2);
  EXPECT_EQ(exception({43, 14, 0, 0}), 3);
  EXPECT_EQ(exception({43, 14, 5, 0}), 3);
  EXPECT_EQ(exception({43, 13, 1, 0}), 1);
  machine_->board = 23;
  EXPECT_EQ(ask({43, 14, 4, 1}), with({43, 14, 4, 0x81, 0, 0, 1}, object(1, "board 23 mpu 3")));
}

TEST_F(Modbus, UnitAndBroadcast) {
  const int frames = holding(c::holding_frames);
  EXPECT_TRUE(send({16, 6, 0, 0, 0, 9}).empty());
  EXPECT_EQ(machine_->words[0], 0);
  EXPECT_TRUE(send({0, 6, 0, 0, 0, 9}).empty());
  EXPECT_EQ(machine_->words[0], 9);
  const int exceptions = holding(c::holding_exceptions);
  EXPECT_TRUE(send({0, 3, 0, 0, 0, 0}).empty());
  EXPECT_TRUE(send({0, 99}).empty());
  EXPECT_EQ(holding(c::holding_exceptions), exceptions);
  EXPECT_EQ(holding(c::holding_frames), frames + 6);
  exception({99});
  EXPECT_EQ(holding(c::holding_exceptions), exceptions + 1);
}

TEST_F(Modbus, OneExchangeARequest) {
  const auto one = [&](const Bytes& request) {
    const int before = machine_->exchanges;
    EXPECT_EQ(exception(request), 0);
    EXPECT_EQ(machine_->exchanges, before + 1) << int(request[0]);
  };
  one(pdu(1, {u16(coils), 512}));
  one(pdu(3, {u16(d), 125}));
  one(pdu(22, {u16(d), 1, 1}));
  one(with(pdu(23, {u16(d), 8, u16(d), 1}), {2, 0, 0}));
  one(with(pdu(15, {u16(coils), 8}), {1, 0}));
}

TEST_F(Modbus, MorePointsThanAnExchangeHas) {
  LoadFile file = sample_program(1);
  file.at(c::space_setup, c::setup_exchange_points, 20);
  install(file.words());
  EXPECT_EQ(holding(c::holding_exchange_points), 20);
  EXPECT_EQ(exception(pdu(1, {u16(coils), 20})), 0);
  EXPECT_EQ(exception(pdu(1, {u16(coils), 21})), 3);
  EXPECT_EQ(exception(with(pdu(23, {u16(d), 19, u16(d), 1}), {2, 0, 0})), 0);
  EXPECT_EQ(exception(with(pdu(23, {u16(d), 20, u16(d), 1}), {2, 0, 0})), 3);
  EXPECT_EQ(exception(pdu(1, {0xDFFF, 21})), 2) << "there is no such address first of all";
  EXPECT_EQ(exception(pdu(3, {c::holding_force_list, 64})), 0) << "of devices only";
}

TEST_F(Modbus, FaultAnswersFailure) {
  machine_->state = 3;
  machine_->fault = 1;
  EXPECT_EQ(exception(pdu(3, {u16(d), 1})), 4);
  EXPECT_EQ(holding(c::holding_state), 3);
  EXPECT_EQ(holding(c::holding_fault), 1);
  EXPECT_EQ(write(c::holding_command, {1}), 4);
  command(5);
  EXPECT_EQ(holding(c::holding_state), 0);
  EXPECT_EQ(exception(pdu(3, {u16(d), 1})), 0);
  machine_->exchange_offered = false;
  EXPECT_EQ(exception(pdu(3, {u16(d), 1})), 4) << "in the end";
}

TEST_F(Modbus, Registers) {
  EXPECT_EQ(read(c::holding_identity, 6),
            (Words{0x5247, 1, 0, u16(config_id()), 3, u16(c::tables)}));
  EXPECT_EQ(read(c::holding_scan_count, 8),
            (Words{0x34, 0x12, 0x78, 0x56, 0xBC, 0x9A, 0xF0, 0xDE}));
  EXPECT_EQ(read(c::holding_scan_max + 1), (Words{0xDE})) << "a high word on its own";
  machine_->bad_crc = 11;
  machine_->overruns = 7;
  EXPECT_EQ(read(c::holding_bad_frames, 3), (Words{11, 12, 13}));
  EXPECT_EQ(holding(c::holding_overruns), 7);
  EXPECT_EQ(holding(c::holding_flags), 1 | 2 | 32);
  EXPECT_EQ(read(c::holding_inputs, 8),
            (Words{0x1140, 0x1141, 0x1142, 0x1143, 0x1144, 0x1145, 0x1146, 0x1147}));
  EXPECT_EQ(read(c::holding_identity + 6, 2), (Words{0, 0})) << "between registers";
  EXPECT_EQ(ask(pdu(4, {c::holding_identity, 1})), (Bytes{4, 2, 0x52, 0x47}));
  EXPECT_EQ(exception(pdu(1, {c::holding_identity, 1})), 2);
  const int last =
      kFlow ? flow::holding_flow + flow::holding_flow_count - 1 : c::holding_window + 63;
  EXPECT_EQ(exception(pdu(3, {u16(last), 1})), 0);
  EXPECT_EQ(exception(pdu(3, {u16(last), 2})), 2);
  EXPECT_EQ(exception(pdu(3, {u16(last + 1), 1})), 2);
  // Not to be written
  for (const int address : {c::holding_identity, c::holding_state, c::holding_force_list,
                            c::holding_load_state, c::holding_identity + 6}) {
    EXPECT_EQ(write(address, {1}), 2) << address;
  }
}

TEST_F(Modbus, DevicesAndRegistersDoNotMix) {
  EXPECT_EQ(exception(with(pdu(23, {u16(d), 1, c::holding_force_point, 1}), {2, 0, 0})), 2);
  EXPECT_EQ(exception(with(pdu(23, {c::holding_force_point, 1, u16(d), 1}), {2, 0, 0})), 2);
  // 23, 22 and 6 on registers: written before read
  EXPECT_EQ(
      ask(with(pdu(23, {c::holding_force_point, 1, c::holding_force_point, 1}), {2, 0x34, 5})),
      (Bytes{23, 2, 0x34, 5}));
  EXPECT_EQ(exception(pdu(22, {c::holding_force_point, 0xFF00, 0x0012})), 0);
  EXPECT_EQ(holding(c::holding_force_point), 0x3412);
  EXPECT_EQ(exception(pdu(6, {c::holding_force_point, 5})), 0);
  EXPECT_EQ(holding(c::holding_force_point), 5);
}

TEST_F(Modbus, NothingTakesEffectWhenOneRegisterIsWrong) {
  EXPECT_EQ(write(c::holding_force_point, {7, 1, 0}), 2);
  EXPECT_EQ(holding(c::holding_force_point), 0);
  EXPECT_EQ(write(c::holding_load_state - 1, {1, 0}), 2);
  EXPECT_EQ(holding(c::holding_load_state), 2);
}

TEST_F(Modbus, Commands) {
  for (const int value : {0, 9, 0xFFFF}) EXPECT_EQ(write(c::holding_command, {u16(value)}), 3);
  EXPECT_EQ(write(c::holding_command, {3}), 4) << "one scan: when stopped";
  EXPECT_EQ(write(c::holding_command, {8}), 4);
  command(2);
  EXPECT_EQ(holding(c::holding_state), 0);
  EXPECT_EQ(holding(c::holding_command), 2);
  command(3);
  EXPECT_EQ(machine_->state, 2);
  poll(8);
  EXPECT_EQ(holding(c::holding_state), 0);
  machine_->overruns = 3;
  command(4);
  EXPECT_EQ(holding(c::holding_overruns), 0);
  machine_->run_switch = false;
  EXPECT_EQ(write(c::holding_command, {1}), 4);
  EXPECT_EQ(write(c::holding_command, {3}), 4);
  poll(2);
  machine_->run_switch = true;
  poll(2);
  EXPECT_EQ(holding(c::holding_state), 1);
}

TEST_F(Modbus, StopToRunClearsAllButWhatIsKept) {
  command(2);
  for (auto& bit : machine_->bits) bit = 1;
  for (auto& word : machine_->words) word = 0x7777;
  const int scans = machine_->first_scans;
  command(1);
  EXPECT_EQ(machine_->first_scans, scans + 1);
  EXPECT_EQ(machine_->loads_while_running, 0);
  for (int n = 0; n < kBitDevices; ++n) EXPECT_EQ(machine_->bits[n], n >= 2 && n <= 7 ? 1 : 0) << n;
  for (int n = 0; n < kWordDevices; ++n) {
    const bool persist = n >= kWordDevices - 19 && n < kWordDevices - 16;
    EXPECT_EQ(machine_->words[n], (n >= 2 && n <= 5) || persist ? 0x7777 : 0) << n;
  }
}

}  // namespace
}  // namespace rung::tb
