// SPDX-License-Identifier: BSD-3-Clause
#include "host/library.hpp"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <boost/dll/shared_library.hpp>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "config/settings.hpp"
#include "host/guard.hpp"
#include "tolman/plugin.hpp"
#include "tolman/version.hpp"

namespace tolman::host {

namespace {

std::string subject(const Manifest& manifest) {
  return "plugin '" + manifest.id + "' (" + manifest.file.string() + ")";
}

std::string version(int major, int minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

std::string fingerprintRemedy(const Manifest& manifest, const HostIdentity& host) {
  const auto differs = [&](const std::string& word) {
    return host.fingerprint.find(word) != std::string::npos &&
           manifest.fingerprint.find(word) == std::string::npos;
  };
  if (differs(" align16")) {
    return "rebuild the plugin without -march, -mavx or -mavx2 (Eigen's alignment follows them), "
           "or rebuild Tolman with -DTOLMAN_MARCH_V3=ON";
  }
  if (differs("sanitizer-")) return "build plugin and host with the same -fsanitize options";
  return "rebuild the plugin with the compiler, flags and Eigen that this Tolman was built with";
}

}  // namespace

HostIdentity HostIdentity::ofThisBuild() {
  return {TOLMAN_SDK_MAJOR, TOLMAN_SDK_MINOR, TOLMAN_FINGERPRINT, TOLMAN_HOST_OPENCV};
}

std::optional<Refusal> checkGate(const Manifest& manifest, const HostIdentity& host) {
  const std::string built = " was built for SDK " +
                            version(manifest.sdk_major, manifest.sdk_minor) +
                            "; this host has SDK " + version(host.sdk_major, host.sdk_minor);
  if (manifest.sdk_major != host.sdk_major) {
    return Refusal{"plugin/sdk-major", subject(manifest) + built,
                   "rebuild the plugin against this SDK; docs/stability.md lists what changed"};
  }
  const bool is_unreleased = host.sdk_major == 0;  // its minor versions may break
  if (manifest.sdk_minor > host.sdk_minor ||
      (is_unreleased && manifest.sdk_minor != host.sdk_minor)) {
    return Refusal{"plugin/sdk-minor", subject(manifest) + built,
                   "rebuild the plugin against this SDK, or use the Tolman that it was built for"};
  }
  if (manifest.fingerprint != host.fingerprint) {
    return Refusal{"plugin/fingerprint",
                   subject(manifest) + " has another build fingerprint:\n    plugin: " +
                       manifest.fingerprint + "\n    host:   " + host.fingerprint,
                   fingerprintRemedy(manifest, host)};
  }
  if (!manifest.opencv.empty() && manifest.opencv != host.opencv) {
    return Refusal{"plugin/opencv",
                   subject(manifest) + " uses OpenCV " + manifest.opencv +
                       "; the plugins of this host use OpenCV " + host.opencv,
                   "build the plugin against OpenCV " + host.opencv};
  }
  return std::nullopt;
}

namespace {

bool isWithin(const ParameterInfo& info) {
  const auto fits = [&](double x) { return x >= info.min && x <= info.max; };
  if (const auto* integer = std::get_if<std::int64_t>(&info.default_value)) {
    return fits(static_cast<double>(*integer));
  }
  if (const auto* real = std::get_if<double>(&info.default_value)) return fits(*real);
  if (const auto* list = std::get_if<std::vector<double>>(&info.default_value)) {
    return std::ranges::all_of(*list, fits);
  }
  if (info.type != ParameterType::Choice) return true;
  const auto* choice = std::get_if<std::string>(&info.default_value);
  return choice != nullptr && std::ranges::find(info.choices, *choice) != info.choices.end();
}

}  // namespace

void checkSchema(const Manifest& manifest, const Schema& schema) {
  Schema reserved = schemaOf<config::StageSettings>();  // keys that the host reads
  if (!manifest.programs.empty())
    std::ranges::copy(config::programSchema(), std::back_inserter(reserved));
  std::set<std::string_view> seen;
  for (const ParameterInfo& info : schema) {
    const auto refuse = [&](const char* what, const char* remedy) {
      const auto& file = manifest.program.empty() ? manifest.file : manifest.program;
      throw Refusal{
          "plugin/bad-schema",
          file.string() + ": parameter '" + info.name + "' of '" + manifest.id + "' " + what,
          remedy};
    };
    if (!seen.insert(info.name).second) refuse("is declared twice", "remove one declaration");
    if (std::ranges::find(reserved, info.name, &ParameterInfo::name) != reserved.end()) {
      refuse("has a name that is reserved for the host", "rename it");
    }
    if (!(info.min <= info.max)) refuse("has an empty range", "swap the ends of .range()");
    if (!info.required && !isWithin(info)) {
      refuse("has a default outside of its range", "correct the default or the range");
    }
  }
}

namespace {

namespace fs = std::filesystem;

bool isOfSystem(const fs::path& file) {
  constexpr std::array kFolders = {"/lib/", "/lib64/", "/usr/lib/", "/usr/lib64/", "/usr/libexec/"};
  return std::ranges::any_of(kFolders,
                             [&](const char* folder) { return file.string().starts_with(folder); });
}

/// What an open library is linked with.
struct Links {
  std::vector<std::string> needed;  ///< names
  std::vector<fs::path> folders;    ///< where the linker looks for them before those of the system
};

Links linksOf(const link_map& library) {
  const char* strings = nullptr;
  std::map<ElfW(Sxword), std::vector<std::size_t>> offsets;
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
    offsets[entry->d_tag].push_back(entry->d_un.d_val);
    if (entry->d_tag != DT_STRTAB) continue;
    // The loader of glibc replaces offsets by addresses where it may write.
    const ElfW(Addr) value = entry->d_un.d_ptr;
    strings = reinterpret_cast<const char*>(  // NOLINT: what the ELF format says
        value < library.l_addr ? library.l_addr + value : value);
  }
  Links links;
  for (const std::size_t offset : offsets[DT_NEEDED]) links.needed.emplace_back(strings + offset);
  const auto addFolders = [&](const std::string& paths) {
    std::istringstream stream(paths);
    for (std::string folder; std::getline(stream, folder, ':');) {
      for (const std::string_view origin : {"${ORIGIN}", "$ORIGIN"}) {
        const std::size_t at = folder.find(origin);
        if (at == std::string::npos) continue;
        folder.replace(at, origin.size(), fs::path(library.l_name).parent_path().string());
      }
      if (!folder.empty()) links.folders.emplace_back(folder);
    }
  };
  for (const std::size_t offset : offsets[DT_RPATH]) addFolders(strings + offset);
  if (const char* all = std::getenv("LD_LIBRARY_PATH")) addFolders(all);
  for (const std::size_t offset : offsets[DT_RUNPATH]) addFolders(strings + offset);
  return links;
}

bool areSame(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  if (fs::equivalent(a, b, ignored)) return true;
  std::array<std::ifstream, 2> files = {std::ifstream(a, std::ios::binary),
                                        std::ifstream(b, std::ios::binary)};
  using Bytes = std::istreambuf_iterator<char>;
  return fs::file_size(a, ignored) == fs::file_size(b, ignored) &&
         std::equal(Bytes(files[0]), Bytes(), Bytes(files[1]), Bytes());
}

/// The libraries that an open one is linked with, directly or by another.
struct Closure {
  std::set<std::string> files;  ///< those that are not of the system
  std::string stranger;         ///< one of another file of that name, in words; usually empty
};

Closure closureOf(const fs::path& library) {
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_NOLOAD);
  link_map* first = nullptr;
  if (handle == nullptr || ::dlinfo(handle, RTLD_DI_LINKMAP, &first) != 0) return {};
  std::map<std::string, const link_map*> open;  // by file name
  const link_map* any = first;
  while (any->l_prev != nullptr) any = any->l_prev;
  for (; any != nullptr; any = any->l_next) {
    if (any->l_ld != nullptr) open.emplace(fs::path(any->l_name).filename().string(), any);
  }
  Closure closure;
  for (std::vector<const link_map*> unread = {first}; !unread.empty();) {
    const Links links = linksOf(*unread.back());
    unread.pop_back();
    for (const std::string& name : links.needed) {
      const auto found = open.find(fs::path(name).filename().string());
      if (found == open.end()) continue;
      std::error_code ignored;
      const fs::path file = fs::weakly_canonical(found->second->l_name, ignored);
      const auto own = std::ranges::find_if(links.folders, [&](const fs::path& folder) {
        return fs::exists(folder / name, ignored);
      });
      if (own != links.folders.end() && !areSame(*own / name, file)) {
        closure.stranger = (*own / name).string() + ", but " + file.string() + " of that name";
      }
      if (isOfSystem(file) || !closure.files.insert(file.string()).second) continue;
      unread.push_back(found->second);
    }
  }
  return closure;
}

using Entry = const PluginDescriptor*();

/// The remedy for a message of the dynamic linker.
std::string remedyFor(std::string_view message) {
  const auto says = [&](const char* part) { return message.find(part) != std::string_view::npos; };
  if (says("failed to map") || says("annot allocate") || says("Too many open files")) {
    return "memory or open files are short (see `ulimit -a`), or the file system is mounted with "
           "noexec: then copy the plugin to another folder";
  }
  if (says("undefined symbol")) {
    return "link the plugin with -Wl,-z,defs (tolman_add_plugin() does) to find missing symbols at "
           "build time";
  }
  return "`ldd` shows missing libraries; a damaged file must be built or copied again";
}

boost::dll::shared_library openPinned(const Manifest& manifest) {
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
    throw Refusal{"plugin/load-failed", file + ": " + error.what(), remedyFor(error.what())};
  }
}

Refusal noEntry(const Manifest& manifest, const std::string& symbol) {
  return {"plugin/entry-missing",
          manifest.file.string() + " has a manifest for '" + manifest.id + "' but no function " +
              symbol,
          "register the class with TOLMAN_PLUGIN, and keep the symbol visible"};
}

const PluginDescriptor* callEntry(const boost::dll::shared_library& library,
                                  const Manifest& manifest) {
  const std::string symbol = "tolman_plugin_" + manifest.id;
  if (!library.has(symbol)) throw noEntry(manifest, symbol);
  try {
    const PluginDescriptor* descriptor = library.get<Entry>(symbol)();
    if (descriptor != nullptr && descriptor->schema != nullptr && descriptor->create != nullptr &&
        descriptor->destroy != nullptr) {
      return descriptor;
    }
  } catch (...) {  // refused below
  }
  throw Refusal{"plugin/entry-failed", manifest.file.string() + ": " + symbol + "() failed",
                "let TOLMAN_PLUGIN write the entry function"};
}

LoadedPlugin describe(const Manifest& manifest, const PluginDescriptor& descriptor) {
  if (descriptor.id != manifest.id || descriptor.role != manifest.role ||
      descriptor.schema_hash != manifest.schema_hash) {
    throw Refusal{
        "plugin/stale-manifest",
        manifest.file.string() + ": the manifest differs from the code of '" + manifest.id + "'",
        "the library was assembled from two builds: build it again from clean"};
  }
  LoadedPlugin plugin{manifest, &descriptor, {}};
  const Status status = contained([&] {
    plugin.schema = descriptor.schema();
    return Status::ok();
  });
  if (!status.isOk()) {
    throw Refusal{"plugin/entry-failed",
                  manifest.file.string() + ": the parameters of '" + manifest.id +
                      "' cannot be listed: " + status.message(),
                  "the constructor of its Parameters must not throw"};
  }
  checkSchema(manifest, plugin.schema);
  return plugin;
}

/// Opens the program of an interpreter.
LoadedPlugin openProgram(const boost::dll::shared_library& library, const Manifest& manifest) {
  const std::string symbol = "tolman_program_" + manifest.id;
  if (!library.has(symbol)) throw noEntry(manifest, symbol);
  Program program;
  const Status status = contained(
      [&] { return library.get<OpenProgram()>(symbol)()(manifest.program.string(), program); });
  if (!status.isOk() || program.descriptor == nullptr) {
    throw Refusal{"plugin/program", manifest.program.string() + ": " + status.message(),
                  "correct the program; `tolman plugins doctor FILE` opens it alone"};
  }
  LoadedPlugin plugin{manifest, program.descriptor, std::move(program.schema)};
  plugin.manifest.role = program.descriptor->role;
  plugin.manifest.version = program.version;
  plugin.manifest.summary = program.summary;
  plugin.manifest.program_files = std::move(program.files);
  checkSchema(plugin.manifest, plugin.schema);
  return plugin;
}

}  // namespace

LoadedPlugin loadPlugin(const Manifest& manifest, const HostIdentity& host) {
  if (const auto refusal = checkGate(manifest, host)) throw *refusal;
  std::set<std::string> changed;
  LoadedPlugin plugin;
  {
    const KeptState kept(true, &changed);  // constructors of the library run now
    const auto library = openPinned(manifest);
    const Closure closure = closureOf(manifest.file);
    if (!closure.stranger.empty()) {
      throw Refusal{"plugin/library-conflict",
                    subject(manifest) + " is linked with " + closure.stranger +
                        " is open already, which the linker takes instead",
                    "give one of the two libraries another name, or set isolation: process for "
                    "one of the stages"};
    }
    if (manifest.programs.empty()) {
      plugin = describe(manifest, *callEntry(library, manifest));
      plugin.manifest.program_files.assign(closure.files.begin(), closure.files.end());
    } else {
      plugin = openProgram(library, manifest);
    }
  }
  plugin.changed = std::move(changed);
  return plugin;
}

}  // namespace tolman::host
