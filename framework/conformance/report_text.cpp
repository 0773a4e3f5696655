// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/report_text.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>

namespace tolman::conformance {
namespace {

std::string indented(const std::string& text) {
  return "         " + boost::replace_all_copy(text, "\n", "\n         ") + "\n";
}

}  // namespace

std::string text(const CheckResult& result) {
  std::string lines =
      fmt::format("{:<9}{:<20}{}", enumName(result.severity()), result.check, result.demand);
  for (const Measurement& measured : result.measurements) {
    lines += fmt::format("\n{:29}{}: {:.4g} {}", "", measured.name, measured.value, measured.unit);
  }
  lines += "\n";
  for (const CheckFinding& finding : result.findings) {
    lines += indented(finding.message);
    if (!finding.remedy.empty()) lines += indented("remedy: " + finding.remedy);
  }
  return lines;
}

std::string summary(const ConformanceReport& report) {
  const bool whole = report.checks.size() > 1;  // --check selected a single one
  const std::string verdict = !report.conforms() ? "does not conform at level"
                              : whole            ? "conforms at level"
                                                 : "one check run, of level";
  return fmt::format("{}: {} {}: {} ok, {} warnings, {} errors, {} skipped; seed {}\n", report.id,
                     verdict, report.level, report.count(CheckSeverity::Ok),
                     report.count(CheckSeverity::Warning), report.count(CheckSeverity::Error),
                     report.count(CheckSeverity::Skip), report.seed);
}

nlohmann::ordered_json json(const ConformanceReport& report) {
  nlohmann::ordered_json checks = nlohmann::ordered_json::array();
  for (const CheckResult& result : report.checks) {
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    for (const CheckFinding& finding : result.findings) {
      findings.push_back({{"severity", enumName(finding.severity)},
                          {"message", finding.message},
                          {"remedy", finding.remedy}});
    }
    nlohmann::ordered_json measurements = nlohmann::ordered_json::array();
    for (const Measurement& measured : result.measurements) {
      measurements.push_back(
          {{"name", measured.name}, {"value", measured.value}, {"unit", measured.unit}});
    }
    checks.push_back({{"check", result.check},
                      {"level", result.level},
                      {"demand", result.demand},
                      {"result", enumName(result.severity())},
                      {"seconds", result.seconds},
                      {"findings", findings},
                      {"measurements", measurements}});
  }
  return {{"id", report.id},
          {"role", report.role},
          {"file", report.file},
          {"level", report.level},
          {"seed", report.seed},
          {"conforms", report.conforms()},
          {"ok", report.count(CheckSeverity::Ok)},
          {"warnings", report.count(CheckSeverity::Warning)},
          {"errors", report.count(CheckSeverity::Error)},
          {"skipped", report.count(CheckSeverity::Skip)},
          {"checks", checks}};
}

}  // namespace tolman::conformance
