#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "felt/base/result.h"
#include "felt/material/materials.h"

namespace felt {

/// What an option holds: a number, a switch, or one of its choices by name.
using OptionValue = std::variant<double, bool, std::string>;

/// What kind of option it is.
enum class OptionKind { kNumber, kSwitch, kChoice };

/// Of which materials a choice may name one that is not listed: `choices` are those that Feltline
/// brings, a session knows more (Session::materials). What is set by a tool alone is any id.
enum class OpenChoice { kNone, kSheets, kMedia };

/// One row of a tool's table of options, constexpr in its room. The desktop's panel,
/// `--set pencil.snap_radius_mm=3`, `feltline tools` and the range tests are all made from it.
struct OptionSpec {
  std::string_view id;     ///< "snap_radius_mm": unique within the tool, unit in the name
  std::string_view label;  ///< for people: "Snap radius"
  std::string_view unit;   ///< "mm", "N", "" for none
  OptionKind kind = OptionKind::kNumber;
  double min = 0.0;       ///< kNumber
  double max = 0.0;       ///< kNumber
  double fallback = 0.0;  ///< default: the number, 0 or 1 of a switch, the index of a choice
  std::span<const std::string_view> choices = {};  ///< kChoice
  std::string_view help;                           ///< one sentence
  /// "mode=brush" or "snap=force|both": another choice of the same table and the values with which
  /// this row means something; a panel shows it then only. "" for always.
  std::string_view when = {};
  OpenChoice open = OpenChoice::kNone;  ///< kChoice
  bool is_seldom = false;               ///< set by few users: a panel folds it away
  bool is_momentary = false;            ///< for the next few gestures: a program does not keep it
};

/// The row that every tool has: how much of its forces is felt. `help` says of which.
constexpr OptionSpec strength_option(std::string_view help) noexcept {
  return {.id = "strength",
          .label = "Strength of forces",
          .unit = "",
          .kind = OptionKind::kNumber,
          .min = 0.0,
          .max = 1.0,
          .fallback = 1.0,
          .choices = {},
          .help = help,
          .when = {},
          .open = OpenChoice::kNone,
          .is_seldom = false,
          .is_momentary = false};
}

/// What the option may be, for messages and help: "it is a number from 0.3 to 20 mm".
std::string allowed_text(const OptionSpec& spec);
/// What a choice may be where these materials are known: those listed, then a person's own; the
/// media that draw.
std::vector<std::string> choices_with(const OptionSpec& spec, const Materials& materials);
/// Error: an open choice is none of those; the message lists them. Other rows say nothing here.
Result<void> check_choice(const OptionSpec& spec, const OptionValue& value,
                          const Materials& materials);
/// Whether the row means something while the choice that its `when` names is this one.
bool matters_with(const OptionSpec& spec, std::string_view choice) noexcept;
/// The option that its `when` names; "" where it always means something.
std::string_view decider_of(const OptionSpec& spec) noexcept;
/// Its default.
OptionValue default_value(const OptionSpec& spec);

/// The values of one table, by index, checked against it.
class OptionValues {
 public:
  /// All at their defaults. The table must outlive this, and its defaults be within its ranges.
  explicit OptionValues(std::span<const OptionSpec> table);

  /// Error: no such option, the wrong kind, or out of range; the message names the option, the
  /// value and what is allowed. Nothing changes then.
  Result<void> set(std::string_view id, const OptionValue& value);
  [[nodiscard]] Result<OptionValue> get(std::string_view id) const;

  /// By index in the table, for the tool itself.
  [[nodiscard]] double number(std::size_t i) const noexcept { return values_[i]; }
  [[nodiscard]] bool is_on(std::size_t i) const noexcept { return values_[i] != 0.0; }
  /// Of a choice that is not open.
  [[nodiscard]] std::size_t choice(std::size_t i) const noexcept {
    return static_cast<std::size_t>(values_[i]);
  }
  /// Of an open one.
  [[nodiscard]] const std::string& open_choice(std::size_t i) const noexcept { return names_[i]; }
  [[nodiscard]] std::span<const OptionSpec> table() const noexcept { return table_; }

  friend bool operator==(const OptionValues& a, const OptionValues& b) noexcept {
    return a.table_.data() == b.table_.data() && a.values_ == b.values_ && a.names_ == b.names_;
  }

 private:
  [[nodiscard]] Result<std::size_t> find(std::string_view id) const;

  std::span<const OptionSpec> table_;
  std::vector<double> values_;
  std::vector<std::string> names_;  // of open choices, "" of others
};

}  // namespace felt
