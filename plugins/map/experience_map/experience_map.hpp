// SPDX-License-Identifier: BSD-3-Clause
// The map role: obeys decisions, takes up revisions, and decides when to correct.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tolman/extras.hpp>
#include <tolman/roles.hpp>
#include <vector>

#include "experience_chain.hpp"
#include "motion_log.hpp"
#include "parameters.hpp"

namespace tolman::experience_map {

class ExperienceMap final : public Map, public StateKeeper {
 public:
  using Parameters = experience_map::Parameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status update(const Motion& motion, const Decision& decision, MapUpdate& update) override;
  Status poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const override;
  Status graph(MapGraph& graph) const override;
  Status finish(const std::vector<MotionRevision>& revisions) override;

  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

 private:
  Status check(const Motion& motion, const Decision& decision) const;
  void revise(const std::vector<MotionRevision>& revisions);
  void startPart();
  void obey(const Decision& decision);
  void correct();
  void noteCorrection(const Status& status);
  bool correctionDue() const;
  void report(MapUpdate& update) const;

  Parameters parameters_;
  Logger* log_ = nullptr;
  MotionLog motions_;
  ExperienceChain chain_;
  std::int64_t version_ = 0;
  std::size_t next_correction_ = 0;  ///< first slot at which correcting is allowed again
};

}  // namespace tolman::experience_map
