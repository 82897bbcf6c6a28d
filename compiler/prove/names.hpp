// SPDX-License-Identifier: Apache-2.0
// What a proof's findings call the places of the memories.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "prove/prove.hpp"

namespace rung::prove {

// The name that the program's traces use; of a device that it does not name, "relay 12 of the
// compiler's" and the like.
std::string place_name(Place place, const std::map<Place, Device>& owners,
                       const image::Image& image);

// ", with X0=1 D3=-7 and 4 more": the start that shows a finding.
std::string start_text(const Finding& finding, const std::function<std::string(Place)>& name);

}  // namespace rung::prove
