// SPDX-License-Identifier: BSD-3-Clause
// Small interfaces that a plugin may implement beside its role. Derive from them as well; the
// plugin macro finds out. New capabilities come as new extras, never as new virtual functions of a
// role, so that old plugins keep loading.
#pragma once

#include <iosfwd>
#include <vector>

#include "tolman/fields.hpp"
#include "tolman/status.hpp"

namespace tolman {

/// Offers internal state as named arrays, to recorder and viewers. Called after each frame, by the
/// same rules of threading as the role itself.
class ArraySource {
 public:
  virtual ~ArraySource() noexcept(false) {}  // as Plugin's, so that one class can be both
  /// Appends arrays. Names and shapes stay the same over a run.
  virtual void arrays(std::vector<NamedArray>& arrays) const = 0;
};

/// Saves and restores all that decides the future. After load() of what save() wrote, the instance
/// answers further frames as the saved one would have. load() of foreign or damaged bytes fails
/// with InvalidInput and leaves the instance as after reset().
class StateKeeper {
 public:
  virtual ~StateKeeper() noexcept(false) {}
  virtual Status save(std::ostream& stream) const = 0;
  virtual Status load(std::istream& stream) = 0;
};

}  // namespace tolman
