// SPDX-License-Identifier: BSD-3-Clause
#include "stated_rate.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "text_file.hpp"
#include "times_and_poses.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

/// What must be wrong besides jitter and lost images, which hardly change the median. Chosen:
/// every second image of a recording is told, because its `rate_hz` is wrong as well.
constexpr double kFactor = 1.5;

struct StatedRate {
  double hz = 0;
  int line = 0;
};

/// Problems of the file are for the reader of the calibration.
std::optional<StatedRate> statedRate(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  Inspection of_calibration;
  for (const TextLine& line : readLines(file, of_calibration)) {
    const auto fields = splitFields(line.text);
    const auto hz =
        fields.size() > 1 && fields[0] == "rate_hz:" ? parseNumber(fields[1]) : std::nullopt;
    if (hz && *hz > 0) return StatedRate{*hz, line.number};
  }
  return std::nullopt;
}

double medianRate(const std::vector<std::int64_t>& stamps_ns) {
  return 1e9 / static_cast<double>(std::max<std::int64_t>(medianStep(stamps_ns), 1));
}

}  // namespace

void checkStatedRate(const fs::path& file, const std::vector<std::int64_t>& stamps_ns,
                     Inspection& inspection) {
  if (stamps_ns.size() < 2) return;
  const std::optional<StatedRate> stated = statedRate(file);
  if (!stated) return;
  const double rate = medianRate(stamps_ns);
  if (rate <= kFactor * stated->hz && stated->hz <= kFactor * rate) return;
  inspection.warning(file, stated->line,
                     "rate_hz is " + fixed(stated->hz, 1) + ", but the images are at " +
                         fixed(rate, 1) +
                         " Hz by their times (median), which are used; if the times are right, "
                         "correct rate_hz, otherwise the times");
}

}  // namespace tolman::image_folders
