#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "felt/base/result.h"
#include "felt/material/materials.h"

namespace felt {

/// The value of an option: a number, a switch, or the name of a choice.
using OptionValue = std::variant<double, bool, std::string>;

/// The type of an option.
enum class OptionKind { kNumber, kSwitch, kChoice };

/// Which materials a choice may name besides the listed ones. `choices` lists the built-in
/// materials, and a session may have more (Session::materials). A tool without a session accepts
/// any id.
enum class OpenChoice { kNone, kSurfaces, kMedia };

/// One row of a tool's option table, which is constexpr in the tool's folder. The desktop's panel,
/// `--set pencil.snap_radius_mm=3`, `feltline tools` and the range tests are all generated from it.
struct OptionSpec {
  std::string_view id;     ///< "snap_radius_mm": unique within the tool, with its unit
  std::string_view label;  ///< shown to the user: "Snap radius"
  std::string_view unit;   ///< "mm", "N", "" for none
  OptionKind kind = OptionKind::kNumber;
  double min = 0.0;       ///< kNumber
  double max = 0.0;       ///< kNumber
  double fallback = 0.0;  ///< default: a number, 0 or 1 for a switch, or the index of a choice
  std::span<const std::string_view> choices = {};  ///< kChoice
  std::string_view help;                           ///< one sentence
  /// Condition for this row to have an effect: the id of a choice in the same table and one or more
  /// of its values, "mode=brush" or "snap=force|both". A panel shows the row only for these values.
  /// "" means always.
  std::string_view when = {};
  OpenChoice open = OpenChoice::kNone;  ///< kChoice
  bool is_seldom = false;               ///< rarely changed: a panel hides it in a collapsed section
  bool is_momentary = false;  ///< meant for the next few gestures: programs do not save it
  /// The id before a rename, or "". Recordings, settings and scripts that use it still work.
  std::string_view former_id = {};
};

/// Returns the row that every tool has: the strength of its forces. `help` says which forces.
constexpr OptionSpec strength_option(std::string_view help, double fallback = 1.0) noexcept {
  return {.id = "strength",
          .label = "Strength of forces",
          .unit = "",
          .kind = OptionKind::kNumber,
          .min = 0.0,
          .max = 1.0,
          .fallback = fallback,
          .choices = {},
          .help = help,
          .when = {},
          .open = OpenChoice::kNone,
          .is_seldom = false,
          .is_momentary = false,
          .former_id = {}};
}

/// Returns a text with the allowed values, for messages and help: "it is a number from 0.3 to 20
/// mm".
std::string allowed_text(const OptionSpec& spec);
/// Returns the values that a choice may have, given these materials: the listed ones, then the
/// user-defined ones. Media that do not draw are left out.
std::vector<std::string> choices_with(const OptionSpec& spec, const Materials& materials);
/// Fails if an open choice does not have one of the values of choices_with(); the message lists
/// them. Always succeeds for other rows.
Result<void> check_choice(const OptionSpec& spec, const OptionValue& value,
                          const Materials& materials);
/// Returns true if the row has an effect while the option named in its `when` has the value
/// `choice`.
bool matters_with(const OptionSpec& spec, std::string_view choice) noexcept;
/// Returns the id of the option that `when` names, or "" if the row always has an effect.
std::string_view decider_of(const OptionSpec& spec) noexcept;
/// Returns the default of the option.
OptionValue default_value(const OptionSpec& spec);

/// The values of all options of one table, by row. set() checks every value against the table.
class OptionValues {
 public:
  /// Sets all options to their defaults. The table must outlive this object. Requires defaults
  /// within their ranges.
  explicit OptionValues(std::span<const OptionSpec> table);

  /// Sets an option. Fails without a change if no option has this id, or if the value is of the
  /// wrong kind or out of range. The message names the option, the value and the allowed values.
  Result<void> set(std::string_view id, const OptionValue& value);
  [[nodiscard]] Result<OptionValue> get(std::string_view id) const;

  /// Return the value of a number or a switch by its index in the table, for the tool itself.
  [[nodiscard]] double number(std::size_t i) const noexcept { return values_[i]; }
  [[nodiscard]] bool is_on(std::size_t i) const noexcept { return values_[i] != 0.0; }
  /// Returns the index of a choice. Requires a choice that is not open.
  [[nodiscard]] std::size_t choice(std::size_t i) const noexcept {
    return static_cast<std::size_t>(values_[i]);
  }
  /// Returns the name of an open choice.
  [[nodiscard]] const std::string& open_choice(std::size_t i) const noexcept { return names_[i]; }
  [[nodiscard]] std::span<const OptionSpec> table() const noexcept { return table_; }

  friend bool operator==(const OptionValues& a, const OptionValues& b) noexcept {
    return a.table_.data() == b.table_.data() && a.values_ == b.values_ && a.names_ == b.names_;
  }

 private:
  [[nodiscard]] Result<std::size_t> find(std::string_view id) const;

  std::span<const OptionSpec> table_;
  std::vector<double> values_;
  std::vector<std::string> names_;  // values of open choices; "" for other options
};

}  // namespace felt
