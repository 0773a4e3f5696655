// SPDX-License-Identifier: BSD-3-Clause
// Saves the state of a run that another run continues.
#pragma once

#include <iosfwd>

#include "sheet_state.hpp"
#include "tolman/status.hpp"

namespace tolman::can_sheet {

Status saveState(const SheetState& state, std::ostream& stream);
/// Loads into a fresh state, which must have the modules and units of the saved one. After a
/// failure the state is not usable.
Status loadState(std::istream& stream, SheetState& state);

}  // namespace tolman::can_sheet
