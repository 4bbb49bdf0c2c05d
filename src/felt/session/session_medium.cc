#include "felt/session/session_medium.h"

#include <variant>

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

}  // namespace felt
