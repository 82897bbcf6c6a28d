// SPDX-License-Identifier: Apache-2.0
// Contacts and what combines them: edges, compares, INV, MEP and MEF.
#pragma once

#include "lower/context.hpp"

namespace rung::lower {

// Lowers the current instruction if it is a contact, a block or a branch; false if it is not.
bool lower_contact(Context& context);

}  // namespace rung::lower
