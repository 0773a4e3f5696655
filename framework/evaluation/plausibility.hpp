// SPDX-License-Identifier: BSD-3-Clause
// Is one of two trajectories read wrongly? Each hypothesis is a transformation of the poses: it
// holds if the motions of truth and estimate agree after it and do not before. Motions over short
// stretches are compared, each in the axes of its own body, so the frames of the two worlds do not
// matter, and drift hardly does.
#pragma once

#include <string>
#include <vector>

#include "evaluation/score.hpp"
#include "evaluation/step_series.hpp"

namespace tolman::evaluation {

/// Root mean square difference of true and estimated motions, relative to the motions themselves: 0
/// for equal ones, about 1.4 for unrelated ones.
struct Misfit {
  double translation = 0;
  double rotation = 0;
  double whole() const;
};

/// A way of reading the poses under which truth and estimate agree.
struct Hypothesis {
  std::string name;  ///< of the row of the table
  std::string text;  ///< "the true poses are world to camera"
  Misfit before;     ///< of the poses as they are read
  Misfit after;
};

/// The hypotheses that hold, best first; of those that are far worse than the best one none.
/// `free_scale`: lengths are not compared. `truth` is whole, the matches have some of its poses.
/// `by_stamp`: estimates have their own stamps, else those of their true poses.
std::vector<Hypothesis> misreadings(const Trajectory& truth, const Matches& matches,
                                    bool free_scale, bool by_stamp);

/// Misfit of motions; see Misfit. `free_scale`: after the scale that fits best.
Misfit misfitOf(std::vector<Stretch> motions, bool free_scale);

// What speaks against a truth or an estimate before anyone believes its figures: is one of the two
// read wrongly (misreadings()), or broken somewhere (step_series.hpp)? Doubts stand beside the
// scores and change none of them.

/// One sentence for each doubt: what was found, and what to look for. Empty for plausible
/// trajectories, whatever the errors of the estimate. Arguments as for score().
std::vector<std::string> doubts(const Trajectory& truth, const Trajectory& estimate,
                                const Protocol& protocol);

/// All doubts in one text; empty without any.
std::string doubtText(const std::vector<std::string>& doubts);

}  // namespace tolman::evaluation
