// SPDX-License-Identifier: BSD-3-Clause
// Reads one section of an ELF file without executing anything. All offsets and sizes are checked,
// so damaged files are refused.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/refusal.hpp"

namespace tolman::host {

/// The bytes of section `name` of a 64-bit little-endian x86-64 shared object. Refusals:
/// plugin/unreadable, plugin/not-elf, plugin/truncated, plugin/wrong-machine, plugin/no-manifest.
OrRefusal<std::string> readElfSection(const std::filesystem::path& file, std::string_view name);

}  // namespace tolman::host
