// SPDX-License-Identifier: BSD-3-Clause
// A small valid sequence in a temporary folder, which tests read or damage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "layouts.hpp"
#include "support/context.hpp"
#include "support/data.hpp"

namespace tolman::image_folders {

/// Four stereo pairs of 64x48 random grey pixels with calibration, times and poses, as KITTI has
/// it.
class DataFolder {
 public:
  static constexpr int kFrames = 4;
  DataFolder();

  std::filesystem::path path(const std::string& name = "") const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Cuts a file to `part` of its length.
  void truncate(const std::string& name, double part) const;
  void writeImage(const std::string& name, int width, int height, int seed = 0) const;
  void remove(const std::string& name) const { std::filesystem::remove_all(path(name)); }

  /// The folder's own path replaced by "DATA", for golden messages.
  std::string anonymous(std::string text) const;

 private:
  test::TemporaryFolder folder_;
};

/// "P0: ..." for a camera of 64x48 pixels whose fourth number is `p3`.
std::string matrixLine(const std::string& name, double p3, double fx = 50);

/// A configured source of the layout with parameters `P`, and what it gave.
template <class P>
struct Opened {
  explicit Opened(const DataFolder& data, ParameterValues values = {})
      : context((values.try_emplace("path", data.path().string()), std::move(values))) {
    const Context services = context;
    Status status = source.configure(services);
    if (status.isOk()) status = source.info(info);
    if (status.isOk()) status = source.rawRig(raw);
    while (status.isOk()) {
      Frame frame;
      status = source.next(frame);
      if (status.isOk()) frames.push_back(std::move(frame));
    }
    code = status.code();
    if (code != StatusCode::EndOfStream) message = data.anonymous(status.message());
    for (const Finding& finding : context.findings) {
      findings.push_back(data.anonymous(std::string(enumName(finding.severity)) + " " +
                                        finding.where + ": " + finding.message));
    }
  }

  test::TestContext context;
  LayoutSource<P> source;
  SourceInfo info;
  RawRig raw;
  std::vector<Frame> frames;
  StatusCode code = StatusCode::Ok;
  std::string message;  ///< of the failure of configure() or next(); empty after the end
  std::vector<std::string> findings;  ///< "severity where: message"
};

}  // namespace tolman::image_folders
