// SPDX-License-Identifier: BSD-3-Clause
// Grid cells on hexagonal lattices: each module holds the position as a phase on a twisted torus
// (Guanella et al. 2007). One module is periodic with a few metres; several of different scale
// (Stensola et al. 2012) have a much longer common period (Fiete et al. 2008). A familiar view
// closes a loop where all modules agree.
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tolman/plugin.hpp>
#include <vector>

namespace {
using tolman::PlanarPose;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr std::size_t kModules = 4;
constexpr double kRatio = 1.42;  // of a module's scale to that of the next smaller one
using Phase = Eigen::Vector2d;   // along the lattice's two axes, 60 degrees apart, in [0, 1)
using Code = std::array<Phase, kModules>;
double lengthOf(const PlanarPose& pose) { return std::hypot(pose.x, pose.y); }

/// The shortest displacement (m) that leads from one phase to the other.
Eigen::Vector2d shortest(const Phase& from, const Phase& to, double scale) {
  Eigen::Vector2d best(scale, scale);
  for (const int du : {-1, 0, 1}) {
    for (const int dv : {-1, 0, 1}) {
      const Eigen::Vector2d p = to - from + Eigen::Vector2d(du, dv);
      const Eigen::Vector2d d = scale * Eigen::Vector2d(p.x() + p.y() / 2, p.y() * std::sqrt(0.75));
      if (d.norm() < best.norm()) best = d;
    }
  }
  return best;
}

class HexagonalGridCells : public tolman::Cells, public tolman::ArraySource {
 public:
  struct Parameters {
    double scale = 30, spacing = 3, unseen = 30;
    static constexpr auto declaration() {
      using tolman::parameter;
      using P = Parameters;
      return tolman::parameters(parameter("scale", &P::scale)
                                    .range(0.1, 1e4)
                                    .unit("m")
                                    .doc("Period of the finest lattice."),
                                parameter("spacing", &P::spacing)
                                    .range(0.01, 1e4)
                                    .unit("m")
                                    .doc("Distance of experiences."),
                                parameter("loop_minimum_travel", &P::unseen)
                                    .range(0, 1e6)
                                    .unit("m")
                                    .doc("Least path to a loop."));
    }
  };

  tolman::Status configure(const tolman::Context& context) override {
    const auto bound = tolman::bindParameters<Parameters>(context.parameters);
    if (bound.isOk()) parameters_ = bound.value();
    return bound.isOk() ? reset() : bound.status();
  }

  tolman::Status reset() override {
    here_ = {}, here_.code.fill(Phase::Zero());
    memories_.clear(), travelled_ = 0, experiences_ = 0;
    return tolman::Status::ok();
  }

  tolman::Status step(const tolman::Motion& motion, const tolman::PlaceObservation& view,
                      tolman::Decision& decision) override {
    integrate(tolman::toPlanar(motion.T_previous_current));
    decision.frame = motion.frame, decision.stamp_ns = motion.stamp_ns;
    decision.template_id = view.template_id;
    if (isBack(view)) {
      here_ = memories_.at(view.template_id);
      here_.heading += view.relative_yaw;
      here_.in_experience = tolman::compose(here_.in_experience, {0, 0, view.relative_yaw});
      decision.action = tolman::Action::CloseLoop;
      decision.relative_yaw = here_.in_experience.theta;
      decision.has_relative_pose = true;
      decision.T_experience_current = tolman::fromPlanar(here_.in_experience);
      decision.covariance = 0.25 * tolman::Matrix6d::Identity();  // half a metre, half a radian
    } else if (here_.experience < 0 || lengthOf(here_.in_experience) >= parameters_.spacing) {
      here_.experience = experiences_++;
      here_.in_experience = {};
      decision.action = tolman::Action::CreateExperience;
    }
    decision.experience = here_.experience;
    decision.heading = tolman::wrapPeriod(here_.heading, kTurn);
    if (view.recognition != tolman::Recognition::None) {
      memories_.try_emplace(view.template_id, here_).first->second.seen_at = travelled_;
    }
    return tolman::Status::ok();
  }

  /// Firing rates of 12 x 12 cells of each module: the sum of three plane waves.
  void arrays(std::vector<tolman::NamedArray>& arrays) const override {
    constexpr int kSide = 12;
    for (std::size_t m = 0; m < kModules; ++m) {
      tolman::NamedArray rates{"grid." + std::to_string(m), {kSide, kSide}, {}};
      for (int i = 0; i < kSide * kSide; ++i) {
        const double a = kTurn * (static_cast<double>(i % kSide) / kSide - here_.code[m].x());
        const double b = kTurn * (static_cast<double>(i / kSide) / kSide - here_.code[m].y());
        const double waves = std::cos(a) + std::cos(b) + std::cos(a + b);  // -1.5 ... 3
        rates.values.push_back(static_cast<float>((waves + 1.5) / 4.5));
      }
      arrays.push_back(std::move(rates));
    }
  }

 private:
  /// State of the robot, now or when a template was made.
  struct Place {
    Code code;
    double heading = 0;  ///< rad, to the left
    std::int64_t experience = -1;
    PlanarPose in_experience;
    double seen_at = 0;  ///< m of path
  };

  double scaleOf(std::size_t m) const { return parameters_.scale * std::pow(kRatio, m); }

  void integrate(const PlanarPose& step) {
    const PlanarPose d = tolman::compose({0, 0, here_.heading}, step);
    for (std::size_t m = 0; m < kModules; ++m) {
      Phase& phase = here_.code[m];
      const double along_v = d.y / (scaleOf(m) * std::sqrt(0.75));
      phase.x() = tolman::wrapPeriod(phase.x() + d.x / scaleOf(m) - along_v / 2, 1);
      phase.y() = tolman::wrapPeriod(phase.y() + along_v, 1);
    }
    here_.heading = d.theta;
    travelled_ += lengthOf(step);
    here_.in_experience = tolman::compose(here_.in_experience, step);
  }

  /// Whether the template was not seen for a while and all modules agree on its position to a tenth
  /// of their scale.
  bool isBack(const tolman::PlaceObservation& view) const {
    const auto seen = memories_.find(view.template_id);
    if (view.recognition != tolman::Recognition::Familiar || seen == memories_.end()) return false;
    const Place& there = seen->second;
    bool is_back = travelled_ - there.seen_at >= parameters_.unseen;
    const Eigen::Vector2d first = shortest(here_.code[0], there.code[0], scaleOf(0));
    for (std::size_t m = 1; m < kModules; ++m) {
      const Eigen::Vector2d way = shortest(here_.code[m], there.code[m], scaleOf(m));
      is_back = is_back && (way - first).norm() < 0.1 * parameters_.scale;
    }
    return is_back;
  }

  Parameters parameters_;
  Place here_;
  std::map<std::int64_t, Place> memories_;  ///< by template id
  double travelled_ = 0;                    ///< m of path
  std::int64_t experiences_ = 0;
};
}  // namespace

TOLMAN_PLUGIN(hexagonal_grid_cells, HexagonalGridCells, "0.1.0",
              "Grid cell modules on hexagonal lattices of several scales.");
