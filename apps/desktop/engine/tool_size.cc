#include "desktop/engine/tool_size.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "felt/tools/tool.h"

namespace felt::desktop {

const Tool& sized_tool(const Session& session) {
  const Tool* draws = session.first_tool(ToolKind::kDraws);
  return session.tool().size() || !draws ? session.tool() : *draws;
}

bool is_line_size(const Session& session) {
  return sized_tool(session).info().kind == ToolKind::kDraws;
}

std::optional<ToolSize> tool_size(const Session& session) {
  return sized_tool(session).size();
}

void resize_selected(Studio& studio) {
  const Session& session = studio.session();
  const std::optional<ToolSize> size = tool_size(session);
  if (!size || !is_line_size(session)) return;
  double sum_mm = 0.0, count = 0.0;
  for (const auto& [id, marks] : session.selection().strokes()) {
    for (const WidthKnot& knot : session.document().find(id)->widths()) {
      sum_mm += knot.width_mm;
      ++count;
    }
  }
  if (count == 0.0) return;
  const double factor = std::clamp(size->mm * count / sum_mm, RestyleEvent::kMinWidthFactor,
                                   RestyleEvent::kMaxWidthFactor);
  studio.apply(RestyleEvent{.width_factor = factor});
}

void set_tool_size(Studio& studio, double mm) {
  if (!std::isfinite(mm)) return;
  const Tool& tool = sized_tool(studio.session());
  for (const auto& [option, value] : tool.options_for_size(mm)) {
    const Result<OptionValue> now = tool.option(option);
    if (now && *now == OptionValue(value)) continue;
    studio.apply(SetOption{std::string(tool.info().id) + "." + std::string(option), value});
  }
}

void step_tool_size(Studio& studio, bool up) {
  const std::optional<ToolSize> size = tool_size(studio.session());
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
  resize_selected(studio);
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
