#include "desktop/panels/tool_size.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "felt/tools/tool.h"

namespace felt::desktop {

void set_tool_size(Studio& studio, double mm) {
  if (!std::isfinite(mm)) return;
  const Tool& tool = studio.session().tool();
  for (const auto& [option, value] : tool.options_for_size(mm)) {
    const Result<OptionValue> now = tool.option(option);
    if (now && *now == OptionValue(value)) continue;
    studio.apply(SetOption{std::string(tool.info().id) + "." + std::string(option), value});
  }
}

void step_tool_size(Studio& studio, bool up) {
  const std::optional<ToolSize> size = studio.session().tool().size();
  if (!size) return;
  const double wanted = std::clamp(next_size(size->mm, up), size->min_mm, size->max_mm);
  constexpr double kHairMm = 1e-6;
  if (std::abs(wanted - size->mm) < kHairMm) {
    const QString mm = QLocale().toString(size->mm, 'g', 3);
    Q_EMIT studio.refused(
        up ? QCoreApplication::translate("ToolSize", "The largest size is %1 mm.").arg(mm)
           : QCoreApplication::translate("ToolSize", "The smallest size is %1 mm.").arg(mm));
    return;
  }
  set_tool_size(studio, wanted);
}

double next_size(double from, bool up) {
  constexpr std::array kSteps = {0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0};
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(from, 1e-3))));
  const double place = from / decade, hair = 1e-6;
  if (up) {
    const auto* above = std::find_if(kSteps.begin(), kSteps.end(),
                                     [&](double step) { return step > place + hair; });
    return (above == kSteps.end() ? 20.0 : *above) * decade;
  }
  const auto below = std::find_if(kSteps.rbegin(), kSteps.rend(),
                                  [&](double step) { return step < place - hair; });
  return (below == kSteps.rend() ? 0.5 : *below) * decade;
}

}  // namespace felt::desktop
