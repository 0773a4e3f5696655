// SPDX-License-Identifier: BSD-3-Clause
#include "engine/loaded_libraries.hpp"

#include <link.h>

#include <array>
#include <filesystem>
#include <string_view>

namespace tolman::run {
namespace {

namespace fs = std::filesystem;
using Libraries = std::map<std::string, std::string>;

constexpr std::array<std::string_view, 9> kNames = {
    "opencv_core", "ceres", "cholmod", "blas", "lapack", "tbb", "embree3", "jpeg", "avcodec"};

int add(dl_phdr_info* library, std::size_t, void* libraries) {
  const fs::path file = library->dlpi_name;
  for (const std::string_view name : kNames) {
    if (!file.filename().string().starts_with("lib" + std::string(name) + ".so")) continue;
    std::error_code error;
    const fs::path resolved = fs::canonical(file, error);
    (*static_cast<Libraries*>(libraries))[std::string(name)] = (error ? file : resolved).string();
  }
  return 0;
}

}  // namespace

std::map<std::string, std::string> loadedLibraries() {
  Libraries libraries;
  ::dl_iterate_phdr(add, &libraries);
  return libraries;
}

}  // namespace tolman::run
