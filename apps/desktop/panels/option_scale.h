#pragma once

#include <QString>

#include "felt/tools/tool_options.h"

namespace felt::desktop {

/// How a number of a table is shown: on a slider, which is finer for small values if the range is
/// wide, and as text with its unit. Shares from 0 to 1 are shown in percent. A value type.
class OptionScale {
 public:
  static constexpr int kPlaces = 1000;  ///< slider positions are 0..kPlaces

  explicit OptionScale(const OptionSpec& spec);

  /// Returns the slider position of a value; clamps a value out of range to the nearest end.
  [[nodiscard]] int place_of(double value) const;
  /// Returns the rounded value of a slider position; the range's ends at its ends.
  [[nodiscard]] double value_at(int place) const;

  /// Returns the factor of the shown number: 100 for a share, otherwise 1.
  [[nodiscard]] double shown_per_unit() const noexcept { return is_share_ ? 100.0 : 1.0; }
  [[nodiscard]] int decimals() const noexcept { return decimals_; }
  /// Returns " mm", " %" or "".
  [[nodiscard]] QString suffix() const;
  /// Returns "20 mm", in the user's locale.
  [[nodiscard]] QString text_of(double value) const;

 private:
  enum class Kind { kEven, kSquare, kLog };

  double min_;
  double max_;
  QString unit_;
  Kind kind_ = Kind::kEven;
  bool is_share_ = false;
  int decimals_ = 1;
};

/// Returns the text of any option's value for the user: "20 mm", "On", "Brush".
QString value_text(const OptionSpec& spec, const OptionValue& value);

}  // namespace felt::desktop
