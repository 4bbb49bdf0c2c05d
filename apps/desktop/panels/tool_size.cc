#include "desktop/panels/tool_size.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "desktop/panels/tool_bar.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

constexpr auto kMin = "pencil.min_width_mm";
constexpr auto kMax = "pencil.max_width_mm";
constexpr double kHairMm = 1e-6;

double number(const Session& session, const std::string& id) {
  const Result<OptionValue> value = session.option(id);
  const double* found = value ? std::get_if<double>(&*value) : nullptr;
  return found ? *found : 0.0;
}

const OptionSpec* spec_of(const Session& session, std::string_view id) {
  const ToolInfo& info = session.tool().info();
  const auto row = std::find_if(info.options.begin(), info.options.end(),
                                [&](const OptionSpec& spec) { return spec.id == id; });
  return row == info.options.end() || row->kind != OptionKind::kNumber ? nullptr : &*row;
}

bool is_pencil(const Session& session) {
  return session.tool().info().id == "pencil";
}

/// How far between the thinnest and the broadest line a mouse draws, 0..1.
double share_of_mouse(const Session& session) {
  const double gamma = std::max(0.1, number(session, "pencil.gamma"));
  return std::pow(std::clamp(number(session, "pencil.mouse_pressure"), 0.0, 1.0), gamma);
}

void set(Studio& studio, const std::string& id, double value) {
  if (number(studio.session(), id) != value) studio.apply(SetOption{id, value});
}

void set_pencil_size(Studio& studio, const ToolSize& size, double mm) {
  const Session& session = studio.session();
  const OptionSpec* least = spec_of(session, "min_width_mm");
  const OptionSpec* most = spec_of(session, "max_width_mm");
  if (!least || !most) return;
  const double share = share_of_mouse(session);
  const double thin =
      std::clamp(number(session, kMin) * mm / size.mm, least->min, std::min(mm, least->max));
  const double broad =
      share > 0.0 ? thin + (mm - thin) / share : number(session, kMax) * mm / size.mm;
  set(studio, kMin, thin);
  set(studio, kMax, std::clamp(broad, std::max(thin, most->min), most->max));
}

}  // namespace

std::optional<ToolSize> tool_size(const Session& session) {
  if (is_pencil(session)) {
    const double thin = number(session, kMin), broad = std::max(thin, number(session, kMax));
    const OptionSpec* most = spec_of(session, "max_width_mm");
    if (!most) return {};
    const double share = share_of_mouse(session);
    const double mm = thin + (broad - thin) * share;
    // Half of the range, so that the broadest line can still follow. Options may be set beyond it.
    return ToolSize{mm, std::min(most->min, mm), std::max(0.5 * most->max, mm)};
  }
  const std::string option = size_option(session).toStdString();
  const OptionSpec* spec = option.empty() ? nullptr : spec_of(session, option);
  if (!spec) return {};
  const std::string id = std::string(session.tool().info().id) + "." + option;
  return ToolSize{number(session, id), spec->min, spec->max};
}

void set_tool_size(Studio& studio, double mm) {
  const std::optional<ToolSize> size = tool_size(studio.session());
  if (!size || !std::isfinite(mm)) return;
  const double wanted = std::clamp(mm, size->min_mm, size->max_mm);
  if (is_pencil(studio.session())) return set_pencil_size(studio, *size, wanted);
  const std::string tool(studio.session().tool().info().id);
  set(studio, tool + "." + size_option(studio.session()).toStdString(), wanted);
}

void step_tool_size(Studio& studio, bool up) {
  const std::optional<ToolSize> size = tool_size(studio.session());
  if (!size) return;
  const double wanted = std::clamp(next_size(size->mm, up), size->min_mm, size->max_mm);
  if (std::abs(wanted - size->mm) < kHairMm) {
    const QString mm = QLocale().toString(size->mm, 'g', 3);
    Q_EMIT studio.refused(
        up ? QCoreApplication::translate("ToolSize", "%1 mm is the largest size.").arg(mm)
           : QCoreApplication::translate("ToolSize", "%1 mm is the smallest size.").arg(mm));
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
