// SPDX-License-Identifier: BSD-3-Clause
#include "host/elf_section.hpp"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <optional>

#include "base/open_files.hpp"

namespace tolman::host {
namespace {

constexpr std::uint64_t kLargestSection = 1U
                                          << 20U;  // bytes; a manifest has about 1 KiB per plugin

/// A file whose reads are checked against its size.
class BoundedFile {
 public:
  explicit BoundedFile(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return;  // a pipe would block
    stream_.open(file, std::ios::binary);
    size_ = std::filesystem::file_size(file, error);
  }

  bool readable() const { return stream_.is_open(); }

  std::optional<std::string> read(std::uint64_t offset, std::uint64_t length) {
    if (offset > size_ || length > size_ - offset) return std::nullopt;
    std::string bytes(length, '\0');
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(offset));
    stream_.read(bytes.data(), static_cast<std::streamsize>(length));
    if (!stream_) return std::nullopt;
    return bytes;
  }

  template <class T>
  std::optional<T> object(std::uint64_t offset) {
    const auto bytes = read(offset, sizeof(T));
    if (!bytes) return std::nullopt;
    T value;
    std::memcpy(&value, bytes->data(), sizeof(T));
    return value;
  }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

Refusal truncated(const std::filesystem::path& file) {
  return {"plugin/truncated", file.string() + " is shorter than its section table requires",
          "the file is damaged: build or copy it again"};
}

std::optional<Refusal> checkHeader(const Elf64_Ehdr& header, const std::filesystem::path& file) {
  const bool machine = header.e_ident[EI_CLASS] == ELFCLASS64 &&
                       header.e_ident[EI_DATA] == ELFDATA2LSB && header.e_machine == EM_X86_64;
  if (machine && header.e_type == ET_DYN) return std::nullopt;
  return Refusal{"plugin/wrong-machine", file.string() + " is not an x86-64 shared library",
                 "build it for this machine, as a shared library, with tolman_add_plugin()"};
}

}  // namespace

OrRefusal<std::string> readElfSection(const std::filesystem::path& file, std::string_view name) {
  BoundedFile elf(file);
  if (!elf.readable()) {
    return Refusal{"plugin/unreadable", file.string() + " cannot be read",
                   file_opening::areDescriptorsShort(1)
                       ? "allow more open files (`ulimit -n`)"
                       : "check that the file exists, and its permissions"};
  }
  const auto magic = elf.read(0, SELFMAG);
  if (!magic || *magic != std::string_view(ELFMAG, SELFMAG)) {
    return Refusal{"plugin/not-elf", file.string() + " is not an ELF file",
                   "name a shared library that was built with tolman_add_plugin()"};
  }
  const auto header = elf.object<Elf64_Ehdr>(0);
  if (!header) return truncated(file);
  if (const auto refusal = checkHeader(*header, file)) return *refusal;

  const auto sectionAt = [&](std::uint64_t i) {
    return elf.object<Elf64_Shdr>(header->e_shoff + i * sizeof(Elf64_Shdr));
  };
  const auto names_section = sectionAt(header->e_shstrndx);
  if (!names_section || names_section->sh_size > kLargestSection) return truncated(file);
  const auto names = elf.read(names_section->sh_offset, names_section->sh_size);
  if (!names) return truncated(file);
  for (std::uint64_t i = 0; i < header->e_shnum; ++i) {
    const auto section = sectionAt(i);
    if (!section) return truncated(file);
    if (section->sh_name >= names->size()) continue;
    if (std::string_view(names->c_str() + section->sh_name) != name) continue;
    if (section->sh_size > kLargestSection) return truncated(file);
    const auto bytes = elf.read(section->sh_offset, section->sh_size);
    if (!bytes) return truncated(file);
    return *bytes;
  }
  return Refusal{"plugin/no-manifest", file.string() + " has no section " + std::string(name),
                 "register the class with TOLMAN_PLUGIN in plugin.cpp, and do not strip sections"};
}

}  // namespace tolman::host
