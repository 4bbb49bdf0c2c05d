#include "desktop/panels/option_scale.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "desktop/engine/tool_texts.h"

namespace felt::desktop {
namespace {

constexpr double kWideRatio = 20.0;  // if max / min is at least kWideRatio, small values get a
                                     // larger part of the slider
constexpr double kWideSpan = 20.0;   // the same applies if min is 0 and max is at least kWideSpan

}  // namespace

OptionScale::OptionScale(const OptionSpec& spec)
    : min_(spec.min),
      max_(spec.max),
      unit_(QString::fromUtf8(spec.unit.data(), qsizetype(spec.unit.size()))) {
  is_share_ = spec.unit.empty() && min_ >= 0.0 && max_ == 1.0;
  if (is_share_) {
    decimals_ = 0;
    return;
  }
  if (min_ > 0.0 && max_ / min_ >= kWideRatio) {
    kind_ = Kind::kLog;
  } else if (min_ == 0.0 && max_ >= kWideSpan) {
    kind_ = Kind::kSquare;
  }
  const double finest = min_ > 0.0 ? min_ : (max_ - min_) / 100.0;
  decimals_ = static_cast<int>(std::clamp(std::ceil(-std::log10(finest) - 1e-9), 1.0, 3.0));
}

int OptionScale::place_of(double value) const {
  const double held = std::clamp(value, min_, max_);
  double share = (held - min_) / (max_ - min_);
  if (kind_ == Kind::kLog) share = std::log(held / min_) / std::log(max_ / min_);
  if (kind_ == Kind::kSquare) share = std::sqrt(share);
  return static_cast<int>(std::lround(share * kPlaces));
}

double OptionScale::value_at(int place) const {
  if (place <= 0) return min_;
  if (place >= kPlaces) return max_;
  const double share = static_cast<double>(place) / kPlaces;
  double value = min_ + share * (max_ - min_);
  if (kind_ == Kind::kLog) value = min_ * std::pow(max_ / min_, share);
  if (kind_ == Kind::kSquare) value = min_ + share * share * (max_ - min_);
  // Two digits are precise enough for a slider and easier to read than six.
  const double digits =
      is_share_ ? 0.01 : std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
  const double step = std::max(digits, std::pow(10.0, -decimals_) / shown_per_unit());
  return std::clamp(std::round(value / step) * step, min_, max_);
}

QString OptionScale::suffix() const {
  if (is_share_) return QStringLiteral(" %");
  return unit_.isEmpty() ? QString() : QStringLiteral(" ") + unit_;
}

QString OptionScale::text_of(double value) const {
  return QLocale().toString(value * shown_per_unit(), 'f', decimals_) + suffix();
}

QString value_text(const OptionSpec& spec, const OptionValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return OptionScale(spec).text_of(*number);
  if (const auto* word = std::get_if<std::string>(&value)) return choice_text(*word);
  return std::get<bool>(value) ? QCoreApplication::translate("OptionsPanel", "on")
                               : QCoreApplication::translate("OptionsPanel", "off");
}

}  // namespace felt::desktop
