// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/image_files.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace tolman::bench {
namespace fs = std::filesystem;

namespace {

bool isImage(const fs::path& file) {
  static const std::set<std::string> kExtensions = {".png", ".jpg", ".jpeg",
                                                    ".PNG", ".JPG", ".JPEG"};
  return kExtensions.contains(file.extension().string());
}

/// Numbered names in the order of their numbers: 2.png before 10.png.
bool precedes(const fs::path& a, const fs::path& b) {
  const auto key = [](const fs::path& file) {
    const std::string stem = file.stem().string();
    return std::tuple(stem.size(), stem);
  };
  return key(a) < key(b);
}

/// Image files by folder, at and below the folders that path parameters name.
std::vector<std::vector<fs::path>> imageFolders(const Schema& schema,
                                                const ParameterValues& values) {
  std::map<fs::path, std::vector<fs::path>> folders;
  for (const ParameterInfo& parameter : schema) {
    const auto value = values.find(parameter.name);
    if (parameter.type != ParameterType::Path || value == values.end()) continue;
    constexpr int kDeepest = 2;
    std::error_code error;
    fs::recursive_directory_iterator entry(std::get<std::string>(value->second),
                                           fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
      if (entry.depth() == kDeepest) entry.disable_recursion_pending();
      if (isImage(entry->path())) folders[entry->path().parent_path()].push_back(entry->path());
    }
  }
  std::vector<std::vector<fs::path>> lists;
  for (auto& [folder, files] : folders) {
    std::ranges::sort(files, precedes);
    lists.push_back(std::move(files));
  }
  return lists;
}

bool samePixels(const Image& a, const Image& b) {
  if (a.width() != b.width() || a.height() != b.height() || a.format() != b.format()) return false;
  const auto bytes = static_cast<std::size_t>(a.width() * bytesPerPixel(a.format()));
  for (int row = 0; row < a.height(); ++row) {
    if (std::memcmp(a.row(row), b.row(row), bytes) != 0) return false;
  }
  return true;
}

}  // namespace

Result<ImageFiles> ImageFiles::find(const Schema& schema, const ParameterValues& values,
                                    const Frame& frame) {
  void* library = ::dlopen(TOLMAN_IMAGE_DECODER, RTLD_NOW | RTLD_LOCAL);  // never closed
  if (library == nullptr) return Status::failed(std::string("no image decoder: ") + ::dlerror());
  ImageFiles files;
  files.decoder_ = reinterpret_cast<Decoder*>(::dlsym(library, "tolman_decode_image"));
  if (files.decoder_ == nullptr) return Status::failed("the image decoder has no entry function");
  files.colour_ = frame.left.format() == PixelFormat::Bgr8;
  const auto folders = imageFolders(schema, values);
  files.left_ = files.filesOf(frame.left, frame.source_index, folders);
  files.right_ = files.filesOf(frame.right, frame.source_index, folders);
  if (files.left_.empty() || files.right_.empty() != frame.right.empty()) {
    return Status::unsupported("its images are not those of files below its path parameters");
  }
  return files;
}

ImageFiles::Files ImageFiles::filesOf(const Image& image, std::int64_t source_index,
                                      const std::vector<Files>& folders) const {
  const auto index = static_cast<std::size_t>(source_index);
  for (const Files& files : folders) {
    Image decoded;
    if (image.empty() || index >= files.size()) continue;
    if (decoder_(files[index].c_str(), colour_, decoded) && samePixels(decoded, image))
      return files;
  }
  return {};
}

Status ImageFiles::decode(std::int64_t source_index) const {
  for (const Files* files : {&left_, &right_}) {
    if (files->empty()) continue;
    const auto index = static_cast<std::size_t>(source_index);
    Image image;
    if (index < files->size() && decoder_((*files)[index].c_str(), colour_, image)) continue;
    return Status::invalidInput("image " + std::to_string(source_index) + " cannot be decoded");
  }
  return Status::ok();
}

}  // namespace tolman::bench
