// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/report_text.hpp"

#include <array>
#include <cstdio>

namespace tolman::conformance {
namespace {

std::string padded(std::string_view text, std::size_t width) {
  std::string line(text);
  line.resize(std::max(width, line.size()), ' ');
  return line;
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string indented(const std::string& text) {
  std::string lines = "         ";
  for (const char c : text) {
    lines += c;
    if (c == '\n') lines += "         ";
  }
  return lines + "\n";
}

}  // namespace

std::string text(const CheckResult& result) {
  std::string lines =
      padded(enumName(result.severity()), 9) + padded(result.check, 20) + result.demand;
  for (const Figure& figure : result.figures) {
    lines +=
        "\n" + std::string(29, ' ') + figure.name + ": " + number(figure.value) + " " + figure.unit;
  }
  lines += "\n";
  for (const Finding& finding : result.findings) {
    lines += indented(finding.message);
    if (!finding.remedy.empty()) lines += indented("remedy: " + finding.remedy);
  }
  return lines;
}

std::string summary(const Report& report) {
  const auto count = [&](Severity severity) { return std::to_string(report.count(severity)); };
  const bool whole = report.checks.size() > 1;  // one asked-for check says nothing of the rest
  const std::string verdict = !report.conforms() ? "does not conform at level "
                              : whole            ? "conforms at level "
                                                 : "one check made, of level ";
  std::string line = report.id + ": " + verdict + std::to_string(report.level) + ": " +
                     count(Severity::Ok) + " ok, " + count(Severity::Warning) + " warnings, " +
                     count(Severity::Error) + " errors, " + count(Severity::Skip) +
                     " skipped; seed " + std::to_string(report.seed);
  return line + "\n";
}

nlohmann::ordered_json json(const Report& report) {
  nlohmann::ordered_json checks = nlohmann::ordered_json::array();
  for (const CheckResult& result : report.checks) {
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    for (const Finding& finding : result.findings) {
      findings.push_back({{"severity", enumName(finding.severity)},
                          {"message", finding.message},
                          {"remedy", finding.remedy}});
    }
    nlohmann::ordered_json figures = nlohmann::ordered_json::array();
    for (const Figure& figure : result.figures) {
      figures.push_back({{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}});
    }
    checks.push_back({{"check", result.check},
                      {"level", result.level},
                      {"demand", result.demand},
                      {"result", enumName(result.severity())},
                      {"seconds", result.seconds},
                      {"findings", findings},
                      {"figures", figures}});
  }
  return {{"id", report.id},
          {"role", report.role},
          {"file", report.file},
          {"level", report.level},
          {"seed", report.seed},
          {"conforms", report.conforms()},
          {"ok", report.count(Severity::Ok)},
          {"warnings", report.count(Severity::Warning)},
          {"errors", report.count(Severity::Error)},
          {"skipped", report.count(Severity::Skip)},
          {"checks", checks}};
}

}  // namespace tolman::conformance
