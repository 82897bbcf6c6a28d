// SPDX-License-Identifier: Apache-2.0
// The readers of files that people bring, each as a function that takes any bytes. Each must
// neither crash nor hang on them, and must say why when it refuses; what it accepts must hold
// together. A fault ends the program, for libFuzzer to see.
#pragma once

#include <string_view>

namespace rung::fuzz {

void read_list(std::string_view bytes);
void read_csv(std::string_view bytes);
void read_ld(std::string_view bytes);
void read_comments(std::string_view bytes);
void read_stimulus(std::string_view bytes);
void read_trace(std::string_view bytes);
void read_ldmicro_trace(std::string_view bytes);
void read_image(std::string_view bytes);
void read_io_map(std::string_view bytes);
void read_load_file(std::string_view bytes);
void read_flow(std::string_view bytes);

}  // namespace rung::fuzz
