// SPDX-License-Identifier: BSD-3-Clause
#include "host/library.hpp"

#include <dlfcn.h>
#include <link.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <array>
#include <boost/dll/shared_library.hpp>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "host/gate.hpp"
#include "host/guard.hpp"
#include "tolman/plugin.hpp"

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

namespace {

using Entry = const PluginDescriptor*();

/// Whether the file system of the file was mounted so that its code cannot be executed.
bool isNoExec(const std::string& file) {
  struct statvfs system {};
  return ::statvfs(file.c_str(), &system) == 0 && (system.f_flag & ST_NOEXEC) != 0;
}

/// The remedy for a message of the dynamic linker about `file`.
std::string remedyFor(const std::string& message, const std::string& file) {
  const auto says = [&](const char* part) { return message.find(part) != std::string::npos; };
  if (says("failed to map") && isNoExec(file)) {
    return "its file system is mounted with the option noexec, which forbids to execute code from "
           "it: copy the plugin to another folder, or mount it with exec";
  }
  if (says("annot allocate") || says("Too many open files") || says("failed to map")) {
    return kLimitsTooLow;
  }
  if (says("undefined symbol")) {
    return "link the plugin with -Wl,-z,defs (tolman_add_plugin() does) to find missing symbols at "
           "build time";
  }
  return "`ldd` shows missing libraries; a damaged file must be built or copied again";
}

OrRefusal<boost::dll::shared_library> openPinned(const Manifest& manifest) {
  namespace dll = boost::dll;
  const std::string file = manifest.file.string();
  try {
    dll::shared_library library(file, dll::load_mode::rtld_now | dll::load_mode::rtld_local);
    // Keeps the library loaded, see loadPlugin().
    if (::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD | RTLD_NODELETE) != nullptr) {
      return library;
    }
    throw std::runtime_error("it cannot be kept in memory");
  } catch (const std::exception& error) {
    return Refusal{"plugin/load-failed", file + ": " + error.what(), remedyFor(error.what(), file)};
  }
}

Refusal noEntry(const Manifest& manifest, const std::string& symbol) {
  return {"plugin/entry-missing",
          manifest.file.string() + " has a manifest for '" + manifest.id + "' but no function " +
              symbol,
          "register the class with TOLMAN_PLUGIN, and keep the symbol visible"};
}

OrRefusal<const PluginDescriptor*> callEntry(const boost::dll::shared_library& library,
                                             const Manifest& manifest) {
  const std::string symbol = "tolman_plugin_" + manifest.id;
  if (!library.has(symbol)) return noEntry(manifest, symbol);
  try {
    const PluginDescriptor* descriptor = library.get<Entry>(symbol)();
    if (descriptor != nullptr && descriptor->schema != nullptr && descriptor->create != nullptr &&
        descriptor->destroy != nullptr) {
      return descriptor;
    }
  } catch (...) {  // refused below
  }
  return Refusal{"plugin/entry-failed", manifest.file.string() + ": " + symbol + "() failed",
                 "let TOLMAN_PLUGIN write the entry function"};
}

OrRefusal<LoadedPlugin> describe(const Manifest& manifest, const PluginDescriptor& descriptor) {
  if (descriptor.id != manifest.id || descriptor.role != manifest.role ||
      descriptor.schema_hash != manifest.schema_hash) {
    return Refusal{
        "plugin/stale-manifest",
        manifest.file.string() + ": the manifest differs from the code of '" + manifest.id + "'",
        "the library was assembled from two builds: build it again from clean"};
  }
  try {
    LoadedPlugin plugin{manifest, &descriptor, descriptor.schema()};
    plugin.manifest.program_files = ownLibraries(manifest.file);
    if (auto refusal = checkSchema(manifest, plugin.schema)) return *refusal;
    return plugin;
  } catch (const std::exception& error) {
    return Refusal{"plugin/entry-failed",
                   manifest.file.string() + ": the parameters of '" + manifest.id +
                       "' cannot be listed: " + error.what(),
                   "the constructor of its Parameters must not throw"};
  }
}

/// Opens the program of an interpreter.
OrRefusal<LoadedPlugin> openProgram(const boost::dll::shared_library& library,
                                    const Manifest& manifest) {
  const std::string symbol = "tolman_program_" + manifest.id;
  if (!library.has(symbol)) return noEntry(manifest, symbol);
  Program program;
  const Status status = contained(
      [&] { return library.get<OpenProgram()>(symbol)()(manifest.program.string(), program); });
  if (!status.isOk() || program.descriptor == nullptr) {
    return Refusal{"plugin/program", manifest.program.string() + ": " + status.message(),
                   "correct the program; `tolman plugins doctor FILE` opens it alone"};
  }
  LoadedPlugin plugin{manifest, program.descriptor, std::move(program.schema)};
  plugin.manifest.role = program.descriptor->role;
  plugin.manifest.version = program.version;
  plugin.manifest.summary = program.summary;
  plugin.manifest.program_files = std::move(program.files);
  if (auto refusal = checkSchema(plugin.manifest, plugin.schema)) return *refusal;
  return plugin;
}

}  // namespace

OrRefusal<LoadedPlugin> loadPlugin(const Manifest& manifest, const HostIdentity& host) {
  if (auto refusal = checkGate(manifest, host)) return *refusal;
  auto opened = openPinned(manifest);
  if (auto* refusal = std::get_if<Refusal>(&opened)) return *refusal;
  const auto& library = std::get<boost::dll::shared_library>(opened);
  if (!manifest.programs.empty()) return openProgram(library, manifest);
  auto entry = callEntry(library, manifest);
  if (auto* refusal = std::get_if<Refusal>(&entry)) return *refusal;
  return describe(manifest, *std::get<const PluginDescriptor*>(entry));
}

}  // namespace tolman::host
