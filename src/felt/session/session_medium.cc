#include "felt/session/session_medium.h"

#include <algorithm>
#include <variant>

#include "felt/material/material_file.h"

namespace felt {

const Medium& medium_in_hand(const Session& session) {
  const Materials& known = session.materials();
  if (session.tool().info().kind == ToolKind::kErases) return *known.find_medium("eraser");
  const Result<OptionValue> option = session.tool().option("medium");
  const auto* id = option ? std::get_if<std::string>(&*option) : nullptr;
  const Medium* medium = id ? known.find_medium(*id) : nullptr;
  return medium ? *medium : known.media().front();
}

std::string drawing_option(const Session& session, std::string_view option) {
  const Tool* tool = session.first_tool(ToolKind::kDraws);
  return (tool ? std::string(tool->info().id) : std::string()) + "." + std::string(option);
}

std::string drawing_medium(const Session& session) {
  const Result<OptionValue> value = session.option(drawing_option(session, "medium"));
  const auto* id = value ? std::get_if<std::string>(&*value) : nullptr;
  return id ? *id : std::string();
}

std::vector<SetOption> options_for_medium(const Session& session, const Medium& medium) {
  const MediumLine& line = medium.line;
  return {{drawing_option(session, "medium"), medium.id},
          {drawing_option(session, "min_width_mm"), line.min_mm},
          {drawing_option(session, "max_width_mm"), line.max_mm},
          {drawing_option(session, "gamma"), line.gamma}};
}

void Session::report_material(std::int64_t time_ns, OpenChoice kind, const OptionValue& value) {
  const auto* id = std::get_if<std::string>(&value);
  if (!options_.on_event || !id || kind == OpenChoice::kNone) return;
  for (const AnyMaterial& own : not_built_in(options_.materials)) {
    const bool is_surface = std::holds_alternative<SurfaceMaterial>(own);
    if (id_of(own) != *id || is_surface != (kind == OpenChoice::kSurfaces)) continue;
    if (std::find(reported_.begin(), reported_.end(), material_key(own)) != reported_.end()) return;
    reported_.push_back(material_key(own));
    record({time_ns, UseMaterial{write_material(own)}});
  }
}

}  // namespace felt
