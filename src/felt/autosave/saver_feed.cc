#include "felt/autosave/saver_feed.h"

#include <utility>
#include <variant>
#include <vector>

#include "felt/material/material_file.h"

namespace felt {
namespace {

bool depends_on_selection(const Session& session) {
  return session.tool().info().kind == ToolKind::kTransforms;
}

}  // namespace

void SaverFeed::begin(const Session& session, StoredDrawing drawing, std::string name,
                      std::string path, bool modified) {
  saver_.begin(std::move(drawing), std::move(name), std::move(path), modified);
  std::vector<Event> events;
  const auto add = [&events](decltype(Event::what) what) {
    events.push_back({0, std::move(what)});
  };
  const auto add_option = [&](const std::string& id) {
    if (const Result<OptionValue> value = session.option(id)) add(SetOption{id, *value});
  };
  add(UseDevice{session.device()});
  for (const AnyMaterial& own : not_built_in(session.materials())) {
    add(UseMaterial{write_material(own)});
  }
  for (const auto& tool : session.tools()) {
    for (const OptionSpec& row : tool->info().options) {
      add_option(std::string(tool->info().id) + "." + std::string(row.id));
    }
  }
  for (const OptionSpec& row : SheetOptions::table()) add_option("sheet." + std::string(row.id));
  add_option("sheet.color");
  add(SelectTool{std::string(session.tool().info().id)});
  layer_ = session.layer();
  add(LayerEvent{LayerEvent::Do::kUse, layer_, {}});
  saver_.context(std::move(events));
  selection_ = 0;
}

void SaverFeed::hear(const Session& session, const Event& event) {
  const bool is_pen = std::holds_alternative<PenEvent>(event.what);
  if (is_pen && !session.gesture_in_work()) tell_selection(session);
  saver_.event(event, session.gesture_in_work());
  if (!is_pen) tell_layer(session);
}

void SaverFeed::hear(const Session& session, const Edit& edit) {
  saver_.edit(edit);
  tell_layer(session);
}

void SaverFeed::tell_layer(const Session& session) {
  if (session.layer() == layer_) return;
  layer_ = session.layer();
  saver_.context({{0, LayerEvent{LayerEvent::Do::kUse, layer_, {}}}});
}

void SaverFeed::tell_selection(const Session& session) {
  if (session.selection_count() == selection_ || !depends_on_selection(session)) return;
  selection_ = session.selection_count();
  saver_.selection(session.selection());
}

}  // namespace felt
