// SPDX-License-Identifier: BSD-3-Clause
// Precision and recall of `view_templates` on a corridor that was walked twice, at ten thresholds
// and with three kinds of cells; docs/results.md names the best ones.
#include <spdlog/fmt/fmt.h>

#include <catch2/catch.hpp>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

using Cells = std::vector<std::string>;

struct Kind {
  Cells settings, thresholds, precision, recall;
};

/// Precision and recall of all claims at one threshold, with two decimals.
std::pair<std::string, std::string> measured(const fs::path& data, const Cells& settings) {
  Cells command = {"bench",   "places",
                   "--json",  inSource("configs/places/openratslam.yaml"),
                   "--pairs", (data / "true_pairs.csv").string(),
                   "--set",   "source.path=" + (data / "images").string()};
  for (const std::string& setting : settings) command.insert(command.end(), {"--set", setting});
  const Finished finished = tolman::test::tolman(command);
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto curve = nlohmann::json::parse(finished.out)["rows"];
  REQUIRE_FALSE(curve.empty());
  return {fmt::format("{:.2f}", curve.back()["precision"].get<double>()),
          fmt::format("{:.2f}", curve.back()["recall"].get<double>())};
}

}  // namespace

TEST_CASE("views: precision and recall at each threshold", "[data]") {
  const auto data = dataOrSkip("places_two_laps");
  if (!data) return;
  const Kind kind = GENERATE(
      Kind{{},
           {"0.04", "0.05", "0.06", "0.07", "0.08", "0.09", "0.1", "0.11", "0.12", "0.14"},
           {"1.00", "1.00", "0.90", "0.80", "0.74", "0.65", "0.68", "0.61", "0.33", "0.17"},
           {"0.07", "0.16", "0.20", "0.36", "0.39", "0.39", "0.52", "0.52", "0.27", "0.20"}},
      Kind{{"place.normalisation=0", "place.patch_radius=4", "place.columns=32", "place.rows=24"},
           {"0.03", "0.04", "0.05", "0.06", "0.07", "0.08", "0.09", "0.1", "0.11", "0.12"},
           {"0.50", "0.67", "0.67", "0.80", "0.88", "0.80", "0.75", "0.62", "0.50", "0.38"},
           {"0.02", "0.05", "0.05", "0.09", "0.16", "0.18", "0.34", "0.36", "0.41", "0.34"}},
      Kind{{"place.cells=gradients", "place.columns=16", "place.rows=12", "place.shift=3",
            "place.vertical_shift=1"},
           {"0.1", "0.11", "0.12", "0.13", "0.14", "0.15", "0.16", "0.17", "0.18", "0.2"},
           {"1.00", "1.00", "1.00", "1.00", "0.92", "0.82", "0.76", "0.62", "0.54", "0.35"},
           {"0.05", "0.16", "0.27", "0.48", "0.52", "0.64", "0.73", "0.52", "0.50", "0.36"}});
  for (std::size_t i = 0; i < kind.thresholds.size(); ++i) {
    CAPTURE(kind.settings, kind.thresholds[i]);
    Cells all = kind.settings;
    all.push_back("place.threshold=" + kind.thresholds[i]);
    const auto [precision, recall] = measured(*data, all);
    CHECK(precision == kind.precision.at(i));
    CHECK(recall == kind.recall.at(i));
  }
}
