// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "experiment/bench_places.hpp"

namespace tolman::bench {
namespace {

/// At most `most` points of the curve, evenly spaced, the last one included.
std::vector<evaluation::PrecisionRecall> thinned(
    const std::vector<evaluation::PrecisionRecall>& curve, std::size_t most) {
  std::vector<evaluation::PrecisionRecall> points;
  const std::size_t count = std::min(most, curve.size());
  for (std::size_t i = 1; i <= count; ++i) points.push_back(curve[i * curve.size() / count - 1]);
  return points;
}

std::string oppositeText(const OppositePlaces& opposite) {
  if (opposite.findable == 0 && opposite.claims.empty()) return "";
  std::string text =
      fmt::format("opposite direction: {} claims, {} right, with a median error of {:.2f} m\n",
                  opposite.claims.size(), opposite.right(), opposite.medianError());
  if (opposite.findable == 0) return text;
  const double share = static_cast<double>(opposite.found) / static_cast<double>(opposite.findable);
  return text +
         fmt::format(
             "{} images pass a known place, {:.3f} of them at most 5 m after a right claim\n",
             opposite.findable, share);
}

nlohmann::ordered_json oppositeJson(const OppositePlaces& opposite) {
  nlohmann::ordered_json claims = nlohmann::ordered_json::array();
  for (const OppositePlaces::Claim& claim : opposite.claims) {
    claims.push_back({{"query", claim.query},
                      {"place", claim.place},
                      {"score", claim.score},
                      {"error_m", claim.error_m},
                      {"right", claim.right}});
  }
  return {{"findable", opposite.findable},
          {"found", opposite.found},
          {"median_error_m", opposite.medianError()},
          {"claims", claims}};
}

}  // namespace

std::string placesBenchText(const PlacesBench& bench) {
  std::string text = fmt::format("{}: place recogniser '{}', {} images, {} templates\n", bench.name,
                                 bench.plugin, bench.images, bench.templates);
  text += fmt::format("{:>10}{:>9}{:>11}{:>9}\n", "score", "claims", "precision", "recall");
  for (const auto& point : thinned(bench.curve, 12)) {
    text += fmt::format("{:>10.4g}{:>9}{:>11.3f}{:>9.3f}\n", point.score, point.claims,
                        point.precision, point.recall);
  }
  text += fmt::format("\n{} images have a place to be found\n", bench.findable);
  for (const double precision : {1.0, 0.99, 0.9}) {
    text += fmt::format("recall at {:.0f} % precision: {:.3f}\n", 100 * precision,
                        evaluation::recallAt(bench.curve, precision));
  }
  if (bench.opposite) text += oppositeText(*bench.opposite);
  text += fmt::format("time of a call: {:.2f} ms median, {:.2f} ms at 99 %\n", bench.median_ms,
                      bench.p99_ms);
  if (bench.state_bytes > 0 && bench.templates > 0) {
    text +=
        fmt::format("saved state: {} bytes, {:.0f} a template\n", bench.state_bytes,
                    static_cast<double>(bench.state_bytes) / static_cast<double>(bench.templates));
  }
  return text;
}

nlohmann::ordered_json placesBenchJson(const PlacesBench& bench) {
  nlohmann::ordered_json claims = nlohmann::ordered_json::array();
  for (const auto& claim : bench.claims) {
    claims.push_back({{"query", claim.query},
                      {"place", claim.place},
                      {"score", claim.score},
                      {"right", claim.right}});
  }
  nlohmann::ordered_json curve = nlohmann::ordered_json::array();
  for (const auto& point : bench.curve) {
    curve.push_back({{"score", point.score},
                     {"claims", point.claims},
                     {"precision", point.precision},
                     {"recall", point.recall}});
  }
  nlohmann::ordered_json json = {{"name", bench.name},
                                 {"plugin", bench.plugin},
                                 {"images", bench.images},
                                 {"templates", bench.templates},
                                 {"findable", bench.findable},
                                 {"recall_at_100", evaluation::recallAt(bench.curve, 1)},
                                 {"recall_at_99", evaluation::recallAt(bench.curve, 0.99)},
                                 {"recall_at_90", evaluation::recallAt(bench.curve, 0.9)},
                                 {"median_ms", bench.median_ms},
                                 {"p99_ms", bench.p99_ms},
                                 {"state_bytes", bench.state_bytes},
                                 {"interrupted", bench.interrupted},
                                 {"curve", curve},
                                 {"claims", claims}};
  if (bench.opposite) json["opposite"] = oppositeJson(*bench.opposite);
  return json;
}

}  // namespace tolman::bench
