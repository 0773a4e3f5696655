// SPDX-License-Identifier: BSD-3-Clause
// What the host passes to a plugin, so that it needs no globals: parameters, logger, collector of
// findings, artefact writer, cancellation, clock, cameras, and the seed of its random streams.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include "tolman/camera.hpp"
#include "tolman/parameters.hpp"
#include "tolman/status.hpp"

namespace tolman {

enum class LogLevel : std::uint8_t { Debug, Info, Warning, Error };
inline constexpr std::array<std::string_view, 4> kLogLevelNames = {"debug", "info", "warning",
                                                                   "error"};
constexpr std::span<const std::string_view> enumNames(LogLevel) { return kLogLevelNames; }

/// Writes to the log of the run, under the name of the stage. Callable from any thread.
class Logger {
 public:
  virtual ~Logger() = default;
  virtual void write(LogLevel level, std::string_view message) = 0;

  void debug(std::string_view message) { write(LogLevel::Debug, message); }
  void info(std::string_view message) { write(LogLevel::Info, message); }
  void warning(std::string_view message) { write(LogLevel::Warning, message); }
  void error(std::string_view message) { write(LogLevel::Error, message); }
};

/// Something in the data that their user should know, such as a damaged image.
struct Finding {
  static constexpr const char* kRecord = "finding";
  enum class Severity : std::uint8_t { Note, Warning, Error };
  static constexpr std::array<std::string_view, 3> kSeverityNames = {"note", "warning", "error"};
  friend constexpr std::span<const std::string_view> enumNames(Severity) { return kSeverityNames; }
  enum class Kind : std::uint8_t { Unusual, Damaged, Contradiction };
  static constexpr std::array<std::string_view, 3> kKindNames = {"unusual", "damaged",
                                                                 "contradiction"};
  friend constexpr std::span<const std::string_view> enumNames(Kind) { return kKindNames; }

  Severity severity = Severity::Note;
  std::string where;     ///< file, with :line where there is one
  std::string message;   ///< what was found
  std::string remedy{};  ///< what to do about it; empty for notes
  Kind kind = Kind::Unusual;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(severity, "", "note, warning or error");
    TOLMAN_FIELD(where, "", "file, with the line where there is one");
    TOLMAN_FIELD(message, "", "what was found");
    TOLMAN_FIELD(remedy, "", "what to do about it");
    TOLMAN_FIELD(kind, "", "unusual, damaged or contradiction");
  }
};

/// Takes what a plugin finds in its data. The plugin adds a finding and goes on with what it can
/// use; the host records all findings, prints each kind of them once with their number, and stops
/// the run after an error unless the configuration has `on_findings: continue`. Return a failed
/// Status only where nothing can be used. Callable from any thread.
///
/// Error: data are left out, or contradict each other so that results could be wrong.
/// Warning: the data are used, and somebody should look at them. Note: for information.
class FindingCollector {
 public:
  virtual ~FindingCollector() = default;
  virtual void add(Finding finding) = 0;
};

/// Whether the run was asked to stop (an interrupt). Long loops should poll it. Callable from any
/// thread.
class Cancellation {
 public:
  virtual ~Cancellation() = default;
  virtual bool requested() const = 0;
};

/// Clock for progress displays and measurements of speed. Results must not depend on it. Callable
/// from any thread.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual std::int64_t steadyNs() const = 0;
};

/// Writes files of the plugin into the run directory. Callable from any thread.
class ArtefactWriter {
 public:
  virtual ~ArtefactWriter() = default;
  /// Writes `bytes` to artefacts/<instance>/<name>, under a temporary name first and then renamed.
  /// `name` is relative, without "..". An existing file is replaced.
  virtual Status write(std::string_view name, std::span<const std::byte> bytes) = 0;
};

/// A seeded random stream with the same numbers on every machine (xoshiro256**, seeded by
/// splitmix64; Blackman and Vigna). Its seed comes from the run's seed and the instance's name, so
/// adding a plugin does not change the numbers of another. Not thread-safe: call fork() for a
/// stream of another thread.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      seed += 0x9e3779b97f4a7c15ULL;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
      z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
      word = z ^ (z >> 31U);
    }
  }

  /// 64 uniform bits.
  std::uint64_t bits() {
    const std::uint64_t result = rotate(state_[1] * 5, 7) * 9;
    const std::uint64_t t = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = rotate(state_[3], 45);
    return result;
  }
  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 ... count - 1; count > 0.
  std::uint64_t below(std::uint64_t count) {
    const std::uint64_t limit = -count % count;  // reject the uneven remainder
    std::uint64_t draw = bits();
    while (draw < limit) draw = bits();
    return draw % count;
  }
  /// Standard normal (Box-Muller; only one number of each pair is used).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  /// An independent stream.
  RandomStream fork() { return RandomStream(bits()); }

 private:
  static std::uint64_t rotate(std::uint64_t x, unsigned k) { return (x << k) | (x >> (64 - k)); }
  std::uint64_t state_[4];
};

/// Given to configure(). Every reference outlives the plugin instance.
struct Context {
  const ParameterValues& parameters;  ///< complete and checked; see bindParameters()
  Logger& log;
  FindingCollector& findings;
  ArtefactWriter& artefacts;
  const Cancellation& cancellation;
  const Clock& clock;
  CameraRig rig;          ///< of the source; empty for the source itself
  std::uint64_t seed;     ///< for RandomStream; the same after reset()
  std::string instance;   ///< the name of this stage in the configuration, e.g. "odometry"
  bool localise = false;  ///< see Localiser
};

}  // namespace tolman
