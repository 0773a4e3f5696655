// SPDX-License-Identifier: BSD-3-Clause
// Parses numbers and booleans of a configuration.
//
// YAML 1.1 reads 010 as eight, 0x10 as sixteen, `on` as true and `.nan` as a number. These
// spellings are refused, because other YAML readers differ; the message gives the unambiguous one.
#pragma once

#include <cstdint>
#include <string>

#include "tolman/status.hpp"

namespace tolman::config {

/// Decimal digits with an optional sign. Not 010, 0x10, 1e3, 2.0.
Result<std::int64_t> readInteger(const std::string& text);

/// A finite decimal number, 1e-3 included. Not 010, 0x10, .nan, .inf.
Result<double> readReal(const std::string& text);

/// `true` or `false` only.
Result<bool> readBool(const std::string& text);

/// The shortest text from which readReal() gives the same number.
std::string writeReal(double value);

/// A YAML scalar that is read as exactly this text, quoted where it must be.
std::string writeText(const std::string& text);

}  // namespace tolman::config
