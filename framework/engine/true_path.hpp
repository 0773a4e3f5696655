// SPDX-License-Identifier: BSD-3-Clause
// True poses for the frames of any source: of the file that `evaluation.truth` names, or of the
// table that a folder of EuRoC, TUM-VI or TUM has beside its images.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>

#include "config/settings.hpp"
#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

class TruePath {
 public:
  /// Reads the file, if there is one. `source_path`: the folder of the images, or empty.
  static Result<TruePath> open(const config::EvaluationSettings& settings,
                               const std::string& source_path);
  bool isGiven() const { return !poses_.empty(); }
  /// Whether apply() changes frames: there is a file, or the truth of the source is of another
  /// body.
  bool applies() const { return isGiven() || has_body_; }
  const std::filesystem::path& file() const { return file_; }
  /// Tables beside images are of the raw left camera, which was turned by this rotation.
  void rectify(const Eigen::Matrix3d& R_rectified_raw);
  /// Sets the truth of the frame; frames without a true pose at their time have none. Poses are
  /// seen from the first one of the file.
  void apply(Frame& frame) const;
  /// Why the frame cannot have a true pose, nor any near it: the clocks differ. Else empty.
  std::string clockProblem(const Frame& frame) const;
  /// That the table beside the images has positions alone, and of which point. Else empty.
  std::string pointProblem() const;

 private:
  std::filesystem::path file_;
  evaluation::Trajectory poses_;
  Eigen::Isometry3d T_body_camera_ = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> T_body_raw_;  ///< of a table beside the images
  std::int64_t offset_ns_ = 0;
  std::int64_t longest_gap_ns_ = 0;
  bool nearest_ = false;
  bool has_body_ = false;  ///< by evaluation.body
  bool is_point_ = false;  ///< a table beside the images has positions alone
};

}  // namespace tolman::engine
