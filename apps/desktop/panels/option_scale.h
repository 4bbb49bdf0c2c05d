#pragma once

#include <QString>

#include "felt/tools/tool_options.h"

namespace felt::desktop {

/// Converts the value of a numeric option to a slider position and to a text with the unit. If the
/// range is wide, the slider has finer steps for small values. Shares from 0 to 1 are shown in
/// percent. A value type.
class OptionScale {
 public:
  static constexpr int kPlaces = 1000;  ///< slider positions are 0..kPlaces

  explicit OptionScale(const OptionSpec& spec);

  /// Returns the slider position of a value. A value out of range gives the nearest end.
  [[nodiscard]] int place_of(double value) const;
  /// Returns the value of a slider position, rounded to a few digits. The ends of the slider give
  /// exactly the ends of the range.
  [[nodiscard]] double value_at(int place) const;

  /// Returns the factor from the value to the shown number: 100 for a share, otherwise 1.
  [[nodiscard]] double shown_per_unit() const noexcept { return is_share_ ? 100.0 : 1.0; }
  [[nodiscard]] int decimals() const noexcept { return decimals_; }
  /// Returns " mm", " %" or "".
  [[nodiscard]] QString suffix() const;
  /// Returns a text such as "20 mm", in the user's locale.
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

/// Returns the text of any option's value for the user, such as "20 mm", "On" or "Brush".
QString value_text(const OptionSpec& spec, const OptionValue& value);

}  // namespace felt::desktop
