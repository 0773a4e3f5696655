// SPDX-License-Identifier: BSD-3-Clause
// Digests of the input data of a sweep, kept in data.json, so that data that have not changed are
// read once.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "record/data_digest.hpp"

namespace tolman::experiment {

/// Digests by path; empty if there are none.
std::map<std::string, record::DataDigest> readKnownData(const std::filesystem::path& sweep);
Status writeKnownData(const std::filesystem::path& sweep,
                      const std::map<std::string, record::DataDigest>& data);

}  // namespace tolman::experiment
