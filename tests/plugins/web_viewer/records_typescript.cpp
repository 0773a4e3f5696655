// SPDX-License-Identifier: BSD-3-Clause
#include "records_typescript.hpp"

#include <set>
#include <type_traits>

#include "wire_records.hpp"

namespace tolman::web_viewer {
namespace {

constexpr const char* kHead =
    "// SPDX-License-Identifier: BSD-3-Clause\n"
    "// Generated from the records' field lists by scripts/build-page; do not edit.\n";

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

std::string literal(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string unitComment(std::string_view unit) {
  return unit.empty() ? ";" : "; // " + std::string(unit);
}

/// run_info to RunInfo.
std::string interfaceName(std::string_view record) {
  std::string name;
  bool starts_word = true;
  for (const char c : record) {
    const bool upper = starts_word && c >= 'a' && c <= 'z';
    if (c != '_') name += upper ? static_cast<char>(c - 'a' + 'A') : c;
    starts_word = c == '_';
  }
  return name;
}

class Generator {
 public:
  /// The interface of a message header; its member `type` is the record's name.
  template <Record R>
  void addHeader() {
    addInterface<R>(interfaceName(R::kRecord) + "Header",
                    "  readonly type: " + literal(R::kRecord) + ";\n");
  }

  void addColumns() {
    std::string names;
    std::string choices;
    for (const RowColumn& column : rowColumns()) {
      names += "  " + literal(column.name) + ",\n";
      if (column.choices.empty()) continue;
      choices += "  " + literal(column.name) + ": [";
      for (const std::string_view choice : column.choices) choices += literal(choice) + ", ";
      choices.replace(choices.size() - 2, 2, "],\n");
    }
    text_ += "\n/** Columns of a history row, in the order of its values. */\n";
    text_ += "export const kColumns = [\n" + names + "] as const;\n";
    text_ += "export type ColumnName = (typeof kColumns)[number];\n";
    text_ += "\n/** Names of the values of columns that hold an enumeration. */\n";
    text_ += "export const kChoices = {\n" + choices + "} as const;\n";
  }

  const std::string& text() const { return text_; }

 private:
  template <Record R>
  void addInterface(const std::string& name, std::string members) {
    const R record;
    visitFields(record, [&](const Field& field, const auto& member) {
      const bool plain = field.name.find('.') == std::string_view::npos;
      const std::string key = plain ? std::string(field.name) : literal(field.name);
      members += "  readonly " + key + ": " + typeName<std::remove_cvref_t<decltype(member)>>() +
                 unitComment(field.unit) + "\n";
    });
    text_ += "\nexport interface " + name + " {\n" + members + "}\n";
  }

  /// Adds the interfaces that the type needs.
  template <class T>
  std::string typeName() {
    if constexpr (IsVector<T>::value) {
      const std::string element = typeName<typename T::value_type>();
      return "readonly " +
             (element.find('|') == std::string::npos ? element : "(" + element + ")") + "[]";
    } else if constexpr (Record<T>) {
      const std::string name = interfaceName(T::kRecord);
      if (known_.insert(name).second) addInterface<T>(name, "");
      return name;
    } else if constexpr (NamedEnum<T>) {
      std::string names;
      for (const std::string_view choice : enumNames(T{})) {
        names += (names.empty() ? "" : " | ") + literal(choice);
      }
      return names;
    } else if constexpr (std::is_same_v<T, bool>) {
      return "boolean";
    } else if constexpr (std::is_arithmetic_v<T>) {
      return "number";
    } else {
      static_assert(std::is_same_v<T, std::string>);
      return "string";
    }
  }

  std::string text_ = kHead;
  std::set<std::string> known_;
};

}  // namespace

std::string recordsTypeScript() {
  Generator generator;
  generator.addHeader<HelloHeader>();
  generator.addHeader<FrameHeader>();
  generator.addHeader<HistoryHeader>();
  generator.addHeader<GraphHeader>();
  generator.addHeader<EndHeader>();
  generator.addColumns();
  return generator.text();
}

}  // namespace tolman::web_viewer
