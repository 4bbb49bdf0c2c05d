// The commands of a session: undo, redo, selection, layers. session.cc handles the samples.
#include <algorithm>
#include <utility>

#include "felt/base/check.h"
#include "felt/session/guide_edit.h"
#include "felt/session/layer_edit.h"
#include "felt/session/line_stroke.h"
#include "felt/session/selection_edit.h"
#include "felt/session/session.h"
#include "felt/session/symmetry_edit.h"
#include "felt/session/timing_edit.h"
#include "felt/tools/stroke_guide.h"

namespace felt {

Result<void> Session::undo() {
  if (gesture_in_progress()) {
    cancel();
    return {};
  }
  if (Result<void> settled = settle(); !settled) return settled;
  if (!history_.can_undo()) return {};
  const Result<Edit> undone = history_.undo(document_);
  if (!undone) return tl::unexpected(undone.error());
  follow(*undone);
  return {};
}

Result<void> Session::redo() {
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  if (!history_.can_redo()) return {};
  const Result<Edit> redone = history_.redo(document_);
  if (!redone) return tl::unexpected(redone.error());
  follow(*redone);
  return {};
}

bool Session::can_show_as_drawn() const {
  return as_drawn_ && as_drawn_->position == history_.position() && !gesture_in_progress();
}

Result<void> Session::show_as_drawn() {
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  if (!can_show_as_drawn()) return {};
  Edit edit = std::move(as_drawn_->edit);
  as_drawn_.reset();
  return commit(std::move(edit));
}

void Session::cancel() {
  tools_[active_]->cancel();
  offer_.reset();
  ink_layer_step_.reset();
  stroke_guide_->stop();
  parts_->retrace.stop();
  parts_->contour_hold.stop();
  show({});
  gesture_is_open_ = false;
}

Result<void> Session::settle() {
  if (!pen_is_down_) return finish();
  cancel();
  return {};
}

Result<void> Session::select_strokes(SelectStrokes::What what) {
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  set_selection(selected(seen(), selection_, what));
  return {};
}

Result<void> Session::delete_selected() {
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  return commit(delete_edit(document_, selection_));
}

Result<void> Session::duplicate_selected() {
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  Result<Edit> edit = duplicate_edit(document_, selection_);
  if (!edit) return tl::unexpected(with_context(edit.error(), "duplicate"));
  if (edit->empty()) return {};
  Selection copies = made_by(*edit);
  if (Result<void> done = commit(*std::move(edit)); !done) return done;
  set_selection(std::move(copies));
  return {};
}

Result<void> Session::move_selected(std::int64_t time_ns, const MoveEvent& event) {
  // Reports an invalid value before anything changes.
  if (Result<void> valid = check_move(event); !valid) return valid;
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  if (option_defaults_ >= kFirmPushDefaults) return move_connected(time_ns, event.by_mm);
  Result<Edit> edit = move_alone_edit(document_, selection_, event.by_mm);
  if (!edit) return tl::unexpected(edit.error());
  if (edit->empty()) return {};
  const bool continues = moved_ && moved_->position == history_.position() &&
                         time_ns - moved_->time_ns <= MoveEvent::kTogetherNs;
  Result<void> done = continues ? commit_with_previous(*std::move(edit)) : commit(*std::move(edit));
  moved_ = RecentChange{time_ns, history_.position()};
  return done;
}

/// Moves the selected strokes and those that follow. Moves in quick succession are one move of the
/// drawing before the first of them, so that lines which are only passed do not follow.
Result<void> Session::move_connected(std::int64_t time_ns, Vec by_mm) {
  const bool continues = moved_ && moved_->after == selection_ && history_.can_undo() &&
                         moved_->position == history_.position() && !history_.can_redo() &&
                         time_ns - moved_->time_ns <= MoveEvent::kTogetherNs;
  RecentChange change{time_ns, 0, by_mm, selection_};
  if (continues) {
    change.by_mm += moved_->by_mm;
    change.before = moved_->before;
    const Result<Edit> undone = history_.undo(document_);
    if (!undone) return tl::unexpected(undone.error());
    follow(*undone);
    set_selection(*change.before);
  }
  Result<MoveEdit> move = move_edit(scene(), change.by_mm);
  if (!move && continues) {
    if (const Result<Edit> redone = history_.redo(document_); redone) follow(*redone);
    set_selection(*moved_->after);
  }
  if (!move) return tl::unexpected(move.error());
  if (move->edit.empty()) return {};
  Result<void> done = commit(std::move(move->edit));
  if (done && move->selection) set_selection(*std::move(move->selection));
  change.position = history_.position();
  change.after = selection_;
  moved_ = std::move(change);
  return done;
}

Result<void> Session::order_selected(OrderEvent::To to) {
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  return commit(order_edit(document_, selection_, to));
}

Result<void> Session::restyle_selected(const RestyleEvent& event) {
  const Medium* medium = options_.materials.find_medium(event.medium);
  if (!event.medium.empty() && (!medium || !medium->draws)) {
    return fail(ErrorCode::kNotFound,
                "restyle: medium: there is no medium \"" + event.medium + "\" for drawing");
  }
  // Reports an invalid value before anything changes.
  if (Result<Edit> edit = restyle_edit({}, {}, event); !edit) return tl::unexpected(edit.error());
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  Result<Edit> edit = restyle_edit(document_, selection_, event);
  if (!edit) return tl::unexpected(edit.error());
  return commit(*std::move(edit));
}

Result<void> Session::change_layer(const LayerEvent& event) {
  if (gesture_in_progress()) return {};
  // Reports an error before anything changes. The call of settle() below does not change layers.
  const bool keeps_one_open = option_defaults_ < kLateLayerDefaults;
  if (Result<Edit> edit = layer_edit(document_, event, layer_, keeps_one_open); !edit) {
    return tl::unexpected(edit.error());
  }
  if (Result<void> settled = settle(); !settled) return settled;
  Result<Edit> edit = layer_edit(document_, event, layer_, keeps_one_open);
  if (!edit) return tl::unexpected(edit.error());
  const LayerId used = used_after(document_, event, *edit);
  if (Result<void> done = commit(*std::move(edit)); !done) return done;
  if (used) {
    layer_ = used;
    bring_into_view(used);
  }
  keep_layer_open();
  return {};
}

Result<void> Session::add_picture(const AddPicture& event) {
  if (gesture_in_progress()) return {};
  // Reports an error before anything changes.
  if (Result<Edit> edit = picture_edit(document_, event, layer_); !edit) {
    return tl::unexpected(edit.error());
  }
  if (Result<void> settled = settle(); !settled) return settled;
  Result<Edit> edit = picture_edit(document_, event, layer_);
  if (!edit) return tl::unexpected(edit.error());
  const LayerId added = edit->layers.front().id;
  if (Result<void> done = commit(*std::move(edit)); !done) return done;
  layer_ = added;
  return {};
}

Result<void> Session::add_line(const AddLine& event) {
  if (gesture_in_progress()) return {};
  Result<Stroke> line = stroke_of_line(event, parts_->ink_medium, parts_->ink_color);
  if (!line) return tl::unexpected(line.error());
  if (Result<void> settled = settle(); !settled) return settled;
  if (Result<void> opened = open_layer_for_ink(); !opened) return opened;
  EditBuilder edit(document_);
  edit.add(layer_, std::make_shared<const Stroke>(*std::move(line)));
  return commit(std::move(edit).build("Line"));
}

Result<void> Session::change_guides(const GuidesEvent& event) {
  if (gesture_in_progress()) return {};
  // Reports an error before anything changes.
  if (Result<Edit> edit = guide_edit(document_, event); !edit) return tl::unexpected(edit.error());
  if (Result<void> settled = settle(); !settled) return settled;
  if (event.what == GuidesEvent::Do::kUnlink) return commit(unlink_edit(document_, selection_));
  Result<Edit> edit = guide_edit(document_, event);
  if (!edit) return tl::unexpected(edit.error());
  return commit(*std::move(edit));
}

Result<void> Session::change_timing(std::int64_t time_ns, const TimingEvent& event) {
  if (gesture_in_progress()) return {};
  // Reports an error before anything changes.
  if (Result<Edit> edit = timing_edit(document_, event); !edit) return tl::unexpected(edit.error());
  if (Result<void> settled = settle(); !settled) return settled;
  Result<Edit> edit = timing_edit(document_, event);
  if (!edit) return tl::unexpected(edit.error());
  if (edit->empty()) return {};
  const bool continues = !event.pairs && moved_ && moved_->position == history_.position() &&
                         time_ns - moved_->time_ns <= TimingEvent::kTogetherNs;
  Result<void> done = continues ? commit_with_previous(*std::move(edit)) : commit(*std::move(edit));
  if (!event.pairs) moved_ = RecentChange{time_ns, history_.position()};
  return done;
}

Result<void> Session::change_body(const BodyEvent& event) {
  if (gesture_in_progress()) return {};
  // Reports an error before anything changes.
  if (Result<Edit> edit = body_edit_edit(document_, event); !edit) {
    return tl::unexpected(edit.error());
  }
  if (Result<void> settled = settle(); !settled) return settled;
  Result<Edit> edit = body_edit_edit(document_, event);
  if (!edit) return tl::unexpected(edit.error());
  return commit(*std::move(edit));
}

void Session::keep_layer_open() {
  const Layer* layer = seen().layer(layer_);
  if (layer && is_open(*layer)) return;
  if (!highest_open_layer(seen()) && highest_open_layer(document_)) set_view({});
  if (const LayerId open = highest_open_layer(seen())) layer_ = open;
  if (!document_.layer(layer_)) layer_ = document_.layers().back().id;
}

bool Session::begins_ink(const PenSample& sample) const {
  const bool adds = draws_ink() || tool().info().kind == ToolKind::kFills;
  return adds && in_contact(sample) && !pen_is_down_ && !must_lift_ && !ring_;
}

Result<void> Session::open_layer_for_ink() {
  const Layer* layer = seen().layer(layer_);
  if (layer && is_open(*layer)) return {};
  Edit edit = add_layer_on_top(document_);
  if (Result<void> fits = check_layer_count(document_, edit); !fits) {
    return tl::unexpected(
        with_context(fits.error(), "all layers are hidden or locked, and none can be added"));
  }
  layer_ = edit.layers.front().id;
  ++ink_layers_;
  show({});
  if (Result<void> done = commit(std::move(edit)); !done) return done;
  ink_layer_step_ = history_.position();
  return {};
}

/// Adds a layer, which is not a step, if the session begins without an open layer. Recordings of
/// versions before kLateLayerDefaults need it to draw the same strokes.
void Session::add_first_open_layer() {
  const bool has_begun = history_.step_count() > 0 || history_.position() > 0;
  if (has_begun || highest_open_layer(document_)) return;
  const Edit edit = add_layer_on_top(document_);
  if (!check_layer_count(document_, edit)) return;
  FELT_CHECK(document_.apply(edit).has_value());
  follow(edit);
}

Result<void> Session::use_view(const UseView& event) {
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  set_view(event.hidden);
  return {};
}

void Session::bring_into_view(LayerId layer) {
  if (!std::binary_search(out_of_view_.begin(), out_of_view_.end(), layer)) return;
  std::vector<LayerId> others = out_of_view_;
  std::erase(others, layer);
  set_view(std::move(others));
}

void Session::set_view(std::vector<LayerId> out_of_view) {
  std::erase_if(out_of_view, [this](LayerId id) { return id == layer_ || !document_.layer(id); });
  std::sort(out_of_view.begin(), out_of_view.end());
  out_of_view.erase(std::unique(out_of_view.begin(), out_of_view.end()), out_of_view.end());
  if (out_of_view == out_of_view_) return;
  if (!seen_) seen_ = std::make_unique<Document>(document_);
  out_of_view_ = std::move(out_of_view);
  Edit edit;
  for (std::size_t i = 0; i < document_.layers().size(); ++i) {
    const Layer& layer = document_.layers()[i];
    const bool is_out = std::binary_search(out_of_view_.begin(), out_of_view_.end(), layer.id);
    const bool is_shown = layer.own_visible && !is_out;
    if (seen_->layers()[i].own_visible == is_shown) continue;  // nothing else can differ
    LayerChange change{layer.id, seen_->layers()[i].state(), layer.state(), i, i};
    change.after->visible = is_shown;
    edit.layers.push_back(std::move(change));
  }
  FELT_CHECK(seen_->apply(edit).has_value());
  if (out_of_view_.empty()) seen_.reset();
  if (!edit.empty()) follow_seen(edit);
}

Edit Session::seen_edit(Edit edit) const {
  return with_layers_hidden(std::move(edit), out_of_view_);
}

Result<std::size_t> Session::find_tool(std::string_view id) const {
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    if (tools_[i]->info().id == id) return i;
  }
  std::string known;
  for (const auto& tool : tools_)
    known += (known.empty() ? "" : ", ") + std::string(tool->info().id);
  return fail(ErrorCode::kNotFound, "no tool \"" + std::string(id) + "\"; the tools are " + known);
}

}  // namespace felt
