// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "experiment/bench.hpp"

namespace tolman::bench {
namespace {

double ratio(const std::vector<BenchPass>& passes, const BenchPass& pass) {
  const double first = passes.front().rate();
  return first > 0 ? pass.rate() / first : 0;
}

std::string passesText(std::string_view what, const std::vector<BenchPass>& passes) {
  std::string text;
  int repeat = 0;
  for (const BenchPass& pass : passes) {
    text += fmt::format("{:<12}{:>6}{:>8}{:>11.1f}{:>8.2f}{:>10.0f}\n", what, ++repeat, pass.frames,
                        pass.rate(), ratio(passes, pass), pass.peak_mib);
  }
  return text;
}

/// One line per stage, one pair of columns per repeat.
std::string stagesText(const std::vector<BenchPass>& passes) {
  std::string text = fmt::format("{:<12}  median and p90, ms a frame, of each repeat\n", "stage");
  for (const std::string_view role : kRoleNames) {
    if (!passes.front().stages.contains(std::string(role))) continue;
    text += fmt::format("{:<12}", role);
    for (const BenchPass& pass : passes) {
      const auto found = pass.stages.find(std::string(role));
      if (found == pass.stages.end()) continue;
      text += fmt::format("{:>11.2f}{:>9.2f}", found->second.median_ms, found->second.p90_ms);
    }
    text += "\n";
  }
  return text;
}

/// Time of rectification over the time of reading and decoding.
double rectificationRatio(const BenchPass& pass) {
  const double decoding_s = pass.seconds - pass.rectifying_s;
  return decoding_s > 0 ? pass.rectifying_s / decoding_s : 0;
}

/// One column per repeat; empty where nothing is rectified.
std::string rectificationText(const std::vector<BenchPass>& passes) {
  std::string text;
  for (const BenchPass& pass : passes) {
    if (pass.rectifying_s > 0) text += fmt::format("{:>8.2f}", rectificationRatio(pass));
  }
  return text.empty() ? text : "rectifying / reading and decoding:" + text + "\n";
}

nlohmann::ordered_json passesJson(const std::vector<BenchPass>& passes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BenchPass& pass : passes) {
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (const auto& [role, timing] : pass.stages) stages[role] = evaluation::toJson(timing);
    list.push_back({{"frames", pass.frames},
                    {"seconds", pass.seconds},
                    {"frames_per_second", pass.rate()},
                    {"ratio", ratio(passes, pass)},
                    {"peak_mib", pass.peak_mib},
                    {"stages", stages}});
    if (pass.rectifying_s > 0) {
      list.back()["rectifying_over_decoding"] = rectificationRatio(pass);
    }
  }
  return list;
}

}  // namespace

std::string benchText(const Bench& bench) {
  std::string text = fmt::format("{}: {}\n", bench.name, bench.source);
  text += fmt::format("{:<12}{:>6}{:>8}{:>11}{:>8}{:>10}\n", "", "repeat", "frames", "frames/s",
                      "ratio", "peak MiB");
  text += passesText("source", bench.source_passes) + passesText("chain", bench.chain_passes);
  text += rectificationText(bench.source_passes);
  const auto& detailed = bench.chain_passes.empty() ? bench.source_passes : bench.chain_passes;
  return detailed.empty() ? text : text + "\n" + stagesText(detailed);
}

nlohmann::ordered_json benchJson(const Bench& bench) {
  return {{"name", bench.name},
          {"source", bench.source},
          {"interrupted", bench.interrupted},
          {"source_passes", passesJson(bench.source_passes)},
          {"chain_passes", passesJson(bench.chain_passes)}};
}

}  // namespace tolman::bench
