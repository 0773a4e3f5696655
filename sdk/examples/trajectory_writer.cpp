// SPDX-License-Identifier: BSD-3-Clause
// Writes the pose that the map gives for each frame at the time of the frame, in TUM format, which
// evo reads. The host's trajectory.tum has the final poses; the difference is the effect of later
// loop closures.
#include <iomanip>
#include <locale>
#include <span>
#include <sstream>
#include <string>
#include <tolman/plugin.hpp>

namespace {

class TrajectoryWriter : public tolman::Observer {
 public:
  struct Parameters {
    std::string file = "online.tum";
    bool skip_lost = false;
    static constexpr auto declaration() {
      return tolman::parameters(
          tolman::parameter("file", &Parameters::file)
              .doc("Name of the file below artefacts/STAGE/ in the run directory."),
          tolman::parameter("skip_lost", &Parameters::skip_lost)
              .doc("Leave out frames with a predicted motion."));
    }
  };

  tolman::Status configure(const tolman::Context& context) override {
    const auto bound = tolman::bindParameters<Parameters>(context.parameters);
    if (!bound.isOk()) return bound.status();
    parameters_ = bound.value();
    log_ = &context.log;
    artefacts_ = &context.artefacts;
    if (parameters_.file.empty() || parameters_.file.find("..") != std::string::npos) {
      return tolman::Status::invalidParameter("file is '" + parameters_.file +
                                              "'; give a plain name such as online.tum");
    }
    return reset();
  }

  tolman::Status reset() override {
    lines_.clear();
    poses_ = left_out_ = 0;
    return tolman::Status::ok();
  }

  tolman::Status begin(const tolman::RunInfo& run) override {
    lines_ = "# " + run.name + ": stamp tx ty tz qx qy qz qw (s, m), T_world_camera\n";
    return tolman::Status::ok();
  }

  tolman::Status observe(const tolman::Snapshot& snapshot) override {
    if (parameters_.skip_lost && snapshot.motion->state == tolman::TrackingState::Lost) {
      ++left_out_;
      return tolman::Status::ok();
    }
    ++poses_;
    lines_ += line(snapshot.frame->stamp_ns, snapshot.map->T_world_camera);
    return tolman::Status::ok();
  }

  tolman::Status finish(const tolman::MapGraph&) override {
    log_->info(std::to_string(poses_) + " poses written to " + parameters_.file + ", " +
               std::to_string(left_out_) + " left out");
    return artefacts_->write(parameters_.file, std::as_bytes(std::span(lines_)));
  }

 private:
  /// The stamp from integers, without rounding.
  static std::string line(std::int64_t stamp_ns, const Eigen::Isometry3d& T_world_camera) {
    constexpr std::int64_t kSecond = 1'000'000'000;
    std::ostringstream text;
    text.imbue(std::locale::classic());  // decimal point in every locale
    text << stamp_ns / kSecond << '.' << std::setw(9) << std::setfill('0') << stamp_ns % kSecond
         << std::setprecision(9);
    const Eigen::Vector3d t = T_world_camera.translation();
    const Eigen::Quaterniond q(T_world_camera.linear());
    for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
      text << ' ' << value;
    }
    return text.str() + '\n';
  }

  Parameters parameters_;
  tolman::Logger* log_ = nullptr;
  tolman::ArtefactWriter* artefacts_ = nullptr;
  std::string lines_;
  std::int64_t poses_ = 0;
  std::int64_t left_out_ = 0;
};

}  // namespace

TOLMAN_PLUGIN(trajectory_writer, TrajectoryWriter, "0.1.0", "The trajectory as known online, TUM.");
