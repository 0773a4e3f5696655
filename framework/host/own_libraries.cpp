// SPDX-License-Identifier: BSD-3-Clause
#include "host/own_libraries.hpp"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace tolman::host {
namespace {

namespace fs = std::filesystem;

bool isOfSystem(const fs::path& file) {
  constexpr std::array kFolders = {"/lib/", "/lib64/", "/usr/lib/", "/usr/lib64/", "/usr/libexec/"};
  return std::ranges::any_of(kFolders,
                             [&](const char* folder) { return file.string().starts_with(folder); });
}

/// The dynamic section of an open library.
class DynamicSection {
 public:
  explicit DynamicSection(const link_map& library) : library_(library) {
    for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
      if (entry->d_tag == DT_STRTAB) strings_ = pointerTo(entry->d_un.d_ptr);
    }
  }
  /// The names of entries of this kind: DT_NEEDED or DT_SONAME.
  std::vector<std::string> names(ElfW(Sxword) tag) const {
    std::vector<std::string> found;
    for (const ElfW(Dyn)* entry = library_.l_ld; entry->d_tag != DT_NULL; ++entry) {
      if (entry->d_tag == tag && strings_ != nullptr) {
        found.emplace_back(strings_ + entry->d_un.d_val);
      }
    }
    return found;
  }

 private:
  /// The loader of glibc replaces offsets by addresses where it may write.
  const char* pointerTo(ElfW(Addr) value) const {
    const ElfW(Addr) address = value < library_.l_addr ? library_.l_addr + value : value;
    return reinterpret_cast<const char*>(address);  // NOLINT: what the ELF format says
  }

  const link_map& library_;
  const char* strings_ = nullptr;
};

/// All open libraries by the names by which others need them.
std::map<std::string, const link_map*> openLibraries(const link_map* any) {
  while (any->l_prev != nullptr) any = any->l_prev;
  std::map<std::string, const link_map*> libraries;
  for (; any != nullptr; any = any->l_next) {
    if (any->l_name == nullptr || *any->l_name == '\0' || any->l_ld == nullptr) continue;
    libraries.emplace(fs::path(any->l_name).filename().string(), any);
    for (const std::string& name : DynamicSection(*any).names(DT_SONAME)) {
      libraries.emplace(name, any);
    }
  }
  return libraries;
}

}  // namespace

std::vector<std::string> ownLibraries(const fs::path& library) {
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_NOLOAD);
  if (handle == nullptr) return {};
  link_map* first = nullptr;
  if (::dlinfo(handle, RTLD_DI_LINKMAP, &first) != 0 || first == nullptr) return {};
  const auto open = openLibraries(first);
  std::set<std::string> files;
  std::vector<const link_map*> unread = {first};
  while (!unread.empty()) {
    const DynamicSection section(*unread.back());
    unread.pop_back();
    for (const std::string& needed : section.names(DT_NEEDED)) {
      const auto found = open.find(fs::path(needed).filename().string());
      if (found == open.end()) continue;
      std::error_code ignored;
      const fs::path file = fs::weakly_canonical(found->second->l_name, ignored);
      if (isOfSystem(file) || !files.insert(file.string()).second) continue;
      unread.push_back(found->second);
    }
  }
  return {files.begin(), files.end()};
}

}  // namespace tolman::host
