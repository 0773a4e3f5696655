// SPDX-License-Identifier: BSD-3-Clause
// Whether a configuration can be checked against the parameters that a plugin declares.
#pragma once

#include <optional>

#include "host/manifest.hpp"
#include "host/refusal.hpp"
#include "tolman/parameters.hpp"

namespace tolman::host {

/// Refuses (plugin/bad-schema) names that are declared twice or are the host's, ranges without a
/// value, and defaults that are outside of their range or choices.
std::optional<Refusal> checkSchema(const Manifest& manifest, const Schema& schema);

}  // namespace tolman::host
