// SPDX-License-Identifier: BSD-3-Clause
// Grid cells on hexagonal lattices. Each module has a scale (ratio about 1.4, Stensola et al. 2012)
// and holds the robot's position as a phase on a twisted torus (Guanella et al. 2007). One module
// repeats itself every few metres; several together hardly ever (Fiete, Burak, Brookes 2008). So
// a familiar view is believed where all modules see the same displacement from its place.
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
    double scale = 30, spacing = 3, loop_minimum_travel = 30;
    static constexpr auto declaration() {
      return tolman::parameters(
          tolman::parameter("scale", &Parameters::scale)
              .range(0.1, 1e4)
              .unit("m")
              .doc("Distance of firing fields in the smallest module."),
          tolman::parameter("spacing", &Parameters::spacing)
              .range(0.01, 1e4)
              .unit("m")
              .doc("Distance after which a new experience is made."),
          tolman::parameter("loop_minimum_travel", &Parameters::loop_minimum_travel)
              .range(0, 1e6)
              .unit("m")
              .doc("Path since a view was last seen before it can close a loop."));
    }
  };

  tolman::Status configure(const tolman::Context& context) override {
    const auto bound = tolman::bindParameters<Parameters>(context.parameters);
    if (!bound.isOk()) return bound.status();
    parameters_ = bound.value();
    return reset();
  }

  tolman::Status reset() override {
    here_ = {};
    here_.code.fill(Phase::Zero());
    memories_.clear();
    travelled_ = 0;
    experiences_ = 0;
    return tolman::Status::ok();
  }

  tolman::Status step(const tolman::Motion& motion, const tolman::PlaceObservation& view,
                      tolman::Decision& decision) override {
    integrate(tolman::toPlanar(motion.T_previous_current));
    decision.frame = motion.frame;
    decision.stamp_ns = motion.stamp_ns;
    decision.template_id = view.template_id;
    const PlanarPose& moved = here_.in_experience;
    if (isBack(view)) {
      here_ = memories_.at(view.template_id).place;
      here_.heading += view.relative_yaw;
      here_.in_experience = tolman::compose(here_.in_experience, {0, 0, view.relative_yaw});
      decision.action = tolman::Action::CloseLoop;
      decision.relative_yaw = here_.in_experience.theta;
      decision.T_experience_current = tolman::fromPlanar(here_.in_experience);
    } else if (here_.experience < 0 || std::hypot(moved.x, moved.y) >= parameters_.spacing) {
      here_.experience = experiences_++;
      here_.in_experience = {};
      decision.action = tolman::Action::CreateExperience;
    }
    decision.experience = here_.experience;
    decision.heading = tolman::wrapPeriod(here_.heading, kTurn);
    remember(view);
    return tolman::Status::ok();
  }

  /// The rate of 12 x 12 cells of each module: three plane waves, as a grid cell's firing field.
  void arrays(std::vector<tolman::NamedArray>& arrays) const override {
    constexpr int kSide = 12;
    for (std::size_t m = 0; m < kModules; ++m) {
      tolman::NamedArray rates{"grid." + std::to_string(m), {kSide, kSide}, {}};
      for (int i = 0; i < kSide * kSide; ++i) {
        const double a = kTurn * (static_cast<double>(i % kSide) / kSide - here_.code[m].x());
        const double b = kTurn * (static_cast<double>(i / kSide) / kSide - here_.code[m].y());
        const double waves = (std::cos(a) + std::cos(b) + std::cos(a + b)) / 3;  // -0.5 ... 1
        rates.values.push_back(static_cast<float>((waves + 0.5) / 1.5));
      }
      arrays.push_back(std::move(rates));
    }
  }

 private:
  /// Where the robot is, or was when it made a template.
  struct Place {
    Code code;
    double heading = 0;  ///< rad, to the left
    std::int64_t experience = -1;
    PlanarPose in_experience;
  };
  struct Memory {
    Place place;
    double seen_at = 0;  ///< m of path
  };

  double scaleOf(std::size_t m) const {
    return parameters_.scale * std::pow(kRatio, static_cast<double>(m));
  }

  void integrate(const PlanarPose& step) {
    const PlanarPose d = tolman::compose({0, 0, here_.heading}, step);
    for (std::size_t m = 0; m < kModules; ++m) {
      Phase& phase = here_.code[m];
      const double along_v = d.y / (scaleOf(m) * std::sqrt(0.75));
      phase.x() = tolman::wrapPeriod(phase.x() + d.x / scaleOf(m) - along_v / 2, 1);
      phase.y() = tolman::wrapPeriod(phase.y() + along_v, 1);
    }
    here_.heading = d.theta;
    travelled_ += std::hypot(step.x, step.y);
    here_.in_experience = tolman::compose(here_.in_experience, step);
  }

  /// Familiar, not seen for a while, and all modules agree on where its place lies: to a tenth of
  /// the smallest scale.
  bool isBack(const tolman::PlaceObservation& view) const {
    const auto found = memories_.find(view.template_id);
    if (view.recognition != tolman::Recognition::Familiar || found == memories_.end() ||
        travelled_ - found->second.seen_at < parameters_.loop_minimum_travel) {
      return false;
    }
    const Code& there = found->second.place.code;
    const Eigen::Vector2d first = shortest(here_.code[0], there[0], scaleOf(0));
    for (std::size_t m = 1; m < kModules; ++m) {
      const Eigen::Vector2d d = shortest(here_.code[m], there[m], scaleOf(m));
      if ((d - first).norm() > 0.1 * parameters_.scale) return false;
    }
    return true;
  }

  void remember(const tolman::PlaceObservation& view) {
    if (view.recognition == tolman::Recognition::None) return;
    memories_.try_emplace(view.template_id, Memory{here_, 0}).first->second.seen_at = travelled_;
  }

  Parameters parameters_;
  Place here_;
  std::map<std::int64_t, Memory> memories_;  ///< by template id
  double travelled_ = 0;                     ///< m of path
  std::int64_t experiences_ = 0;
};

}  // namespace

TOLMAN_PLUGIN(hexagonal_grid_cells, HexagonalGridCells, "0.1.0",
              "Grid cell modules on hexagonal lattices of several scales.");
