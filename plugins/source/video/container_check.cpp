// SPDX-License-Identifier: BSD-3-Clause
#include "container_check.hpp"

#include "matroska_check.hpp"
#include "mp4_check.hpp"
#include "stream_checks.hpp"

namespace tolman::video {

ContainerCheck checkContainer(const std::filesystem::path& path, std::string_view format) {
  ContainerBytes file(path);
  if (format.starts_with("mov,mp4")) return checkMp4(file);
  if (format.starts_with("matroska")) return {defectOfMatroska(file), std::nullopt};
  if (format == "ogg") return {defectOfOgg(file), std::nullopt};
  if (format == "flv") return {defectOfFlv(file), std::nullopt};
  return {};
}

}  // namespace tolman::video
