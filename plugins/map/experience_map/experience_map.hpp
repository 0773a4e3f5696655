// SPDX-License-Identifier: BSD-3-Clause
// Map `experience_map`: implements the role Map with the experience graph of arXiv 2003.03091,
// section "Cognitive Map". Each update applies the revisions of a motion, the motion and the cells'
// decision. If this changes a loop, or a motion within a loop, the map is corrected, but not before
// `interval` frames, plus `interval_growth` per node, have passed since the last correction.
// finish() corrects it a last time and rejects false loops.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tolman/extras.hpp>
#include <tolman/roles.hpp>
#include <vector>

#include "dead_reckoning.hpp"
#include "experience_chain.hpp"
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
  Status check(const EarlierLoop& loop) const;
  void revise(const std::vector<MotionRevision>& revisions);
  void warnOfUnknown(std::size_t count, const char* what) const;
  void startPart();
  void applyDecision(const Decision& decision);
  void insertEarlier(const std::vector<EarlierLoop>& loops);
  void correct();
  void noteCorrection(const Status& status);
  bool correctionDue() const;
  void reportErrors() const;
  std::string causeOfResiduals() const;
  void report(MapUpdate& update) const;

  Parameters parameters_;
  Logger* log_ = nullptr;
  FindingCollector* findings_ = nullptr;
  DeadReckoning motions_;
  ExperienceChain chain_;
  std::int64_t version_ = 0;
  /// Slot of the first frame at which the map may be corrected again.
  std::size_t next_correction_ = 0;
};

}  // namespace tolman::experience_map
