#pragma once

/// The keys of a study file, in one table for the reader, its messages and its document. Internal.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "felt/material/toml_entries.h"
#include "felt/trial/study.h"

namespace felt {

enum class StudyKeyKind {
  kNumber,
  kWhole,
  kSwitch,
  kId,       ///< 1 to 64 of a-z, 0-9 and -
  kText,     ///< one line
  kFile,     ///< the name of a file, without folders
  kChoice,   ///< one of `choices`
  kChoices,  ///< a list of different `choices`
  kSettings  ///< a table of options and their values
};

/// Where a key writes its value. `condition`, `shape` and `hypothesis` are valid for the keys of
/// these tables.
struct StudyTarget {
  Study* study = nullptr;
  StudyCondition* condition = nullptr;
  StudyShape* shape = nullptr;
  StudyHypothesis* hypothesis = nullptr;
};

/// A value of the type of its key.
struct StudyValue {
  double number = 0.0;
  bool is_on = false;
  std::string text;
  std::size_t choice = 0;  ///< kChoice and kChoices
};

/// One row of the table.
struct StudyKey {
  std::string_view id;  ///< "condition.guidance"
  StudyKeyKind kind;
  double min = 0.0;                                ///< kNumber and kWhole
  double max = 0.0;                                ///< kNumber and kWhole
  std::span<const std::string_view> choices = {};  ///< kChoice and kChoices
  bool takes_switch = false;  ///< kChoice: false and true are the first and the last choice, too
  std::string_view fallback = {};  ///< the value without the key, for the document
  std::string_view help = {};
  /// Writes an allowed value. Called once for each value of a list. Null for kSettings.
  void (*set)(const StudyTarget& target, const StudyValue& value) = nullptr;
};

/// Returns all keys, in the order of the document.
std::span<const StudyKey> study_keys() noexcept;

/// Returns the table of a key, "" for the top level: "condition" for "condition.guidance".
std::string_view study_table_of(std::string_view key) noexcept;

/// Returns the allowed values for messages and the document: "0.1 to 100", "one of none, groove".
std::string allowed_text(const StudyKey& key);

/// Returns the value of an entry, or nullopt if it has the wrong type or is out of range. For a
/// list, the entry is one of its values. Always returns nullopt for kSettings.
std::optional<StudyValue> study_value(const StudyKey& key, const TomlEntry& entry);

/// Returns true for 1 to 200 bytes of text without control characters.
bool is_study_text(std::string_view text) noexcept;

}  // namespace felt
