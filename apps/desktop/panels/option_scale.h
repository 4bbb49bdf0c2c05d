#pragma once

#include <QString>

#include "felt/tools/tool_options.h"

namespace felt::desktop {

/// How a number of a table is shown: on a slider, which is finer for small values where the range
/// is wide, and as text with its unit. Shares from 0 to 1 are shown in percent. A value.
class OptionScale {
 public:
  static constexpr int kPlaces = 1000;  ///< of the slider, 0..kPlaces

  explicit OptionScale(const OptionSpec& spec);

  /// Place on the slider; the nearest end for what is out of range.
  [[nodiscard]] int place_of(double value) const;
  /// The round number at a place; the range's ends at its ends.
  [[nodiscard]] double value_at(int place) const;

  /// What is shown for 1: 100 for a share, else 1.
  [[nodiscard]] double shown_per_unit() const noexcept { return is_share_ ? 100.0 : 1.0; }
  [[nodiscard]] int decimals() const noexcept { return decimals_; }
  /// " mm", " %" or "".
  [[nodiscard]] QString suffix() const;
  /// "20 mm": for people, in their locale.
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

/// "20 mm", "On", "Brush": a value of any row, for people.
QString value_text(const OptionSpec& spec, const OptionValue& value);

}  // namespace felt::desktop
