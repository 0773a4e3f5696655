// SPDX-License-Identifier: BSD-3-Clause
#include "host/schema.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include "config/settings.hpp"

namespace tolman::host {
namespace {

struct Complaint {
  const char* what = nullptr;  ///< null: none
  const char* remedy = nullptr;
};

bool isWithin(const ParameterInfo& info) {
  const auto fits = [&](double x) { return x >= info.min && x <= info.max; };
  if (const auto* integer = std::get_if<std::int64_t>(&info.default_value)) {
    return fits(static_cast<double>(*integer));
  }
  if (const auto* real = std::get_if<double>(&info.default_value)) return fits(*real);
  if (const auto* list = std::get_if<std::vector<double>>(&info.default_value)) {
    return std::ranges::all_of(*list, fits);
  }
  if (info.type != ParameterType::Choice) return true;
  const auto* choice = std::get_if<std::string>(&info.default_value);
  return choice != nullptr && std::ranges::find(info.choices, *choice) != info.choices.end();
}

Complaint complaintAbout(const ParameterInfo& info, const Schema& reserved) {
  if (std::ranges::find(reserved, info.name, &ParameterInfo::name) != reserved.end()) {
    return {"has a name that is reserved for the host", "rename it"};
  }
  if (!(info.min <= info.max)) return {"has an empty range", "swap the ends of .range()"};
  if (!info.required && !isWithin(info)) {
    return {"has a default outside of its range", "correct the default or the range"};
  }
  return {};
}

Refusal refusal(const Manifest& manifest, const std::string& name, const Complaint& complaint) {
  const auto& file = manifest.program.empty() ? manifest.file : manifest.program;
  return {"plugin/bad-schema",
          file.string() + ": parameter '" + name + "' of '" + manifest.id + "' " + complaint.what,
          complaint.remedy};
}

}  // namespace

std::optional<Refusal> checkSchema(const Manifest& manifest, const Schema& schema) {
  Schema reserved = schemaOf<config::StageSettings>();  // keys that the host reads
  if (!manifest.programs.empty())
    std::ranges::copy(config::programSchema(), std::back_inserter(reserved));
  std::set<std::string_view> seen;
  for (const ParameterInfo& info : schema) {
    const bool is_new = seen.insert(info.name).second;
    const Complaint complaint = is_new ? complaintAbout(info, reserved)
                                       : Complaint{"is declared twice", "remove one declaration"};
    if (complaint.what != nullptr) return refusal(manifest, info.name, complaint);
  }
  return std::nullopt;
}

}  // namespace tolman::host
