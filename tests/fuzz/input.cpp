// SPDX-License-Identifier: BSD-3-Clause
#include "input.hpp"

#include <sys/mman.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace tolman::fuzz {

namespace fs = std::filesystem;

void require(bool sound, const char* what) {
  if (sound) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

MemoryFile::MemoryFile(Bytes bytes) : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
  require(descriptor_ >= 0, "no file in memory");
  for (Bytes left = bytes; !left.empty();) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    require(written > 0, "the input cannot be written");
    left = left.subspan(static_cast<std::size_t>(written));
  }
  path_ = "/proc/self/fd/" + std::to_string(descriptor_);
}

ScratchFolder::ScratchFolder() {
  const fs::path memory = "/dev/shm";
  std::error_code ignored;
  const bool usable = ::access(memory.c_str(), W_OK) == 0;
  std::string name =
      ((usable ? memory : fs::temp_directory_path(ignored)) / "tolman-fuzz-XXXXXX").string();
  require(::mkdtemp(name.data()) != nullptr, "no scratch folder");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void ScratchFolder::write(const std::string& name, std::string_view bytes) const {
  std::ofstream stream(path_ / name, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(stream.good(), "the input cannot be written");
}

std::vector<std::string_view> partsOf(std::string_view text) {
  constexpr std::string_view kMark = "%%\n";
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t at = 0; (at = text.find(kMark, at)) != std::string_view::npos; ++at) {
    if (at > 0 && text[at - 1] != '\n') continue;
    parts.push_back(text.substr(begin, at - begin));
    begin = at + kMark.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

}  // namespace tolman::fuzz
