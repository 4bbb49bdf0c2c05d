// How a session commits edits, and how its fills, linked strokes and guides follow them.
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "felt/fill/follow_edit.h"
#include "felt/session/session.h"
#include "felt/session/stroke_joins.h"
#include "felt/session/symmetry_edit.h"

namespace felt {
namespace {

/// Returns what the tool that fills says about fills whose boundary is opened.
WhenOpened when_opened(const Session& session) {
  const Tool* fills = session.first_tool(ToolKind::kFills);
  const Result<OptionValue> value =
      fills ? fills->option("opened") : Result<OptionValue>(std::string("close"));
  return value && *value == OptionValue(std::string("remove")) ? WhenOpened::kRemove
                                                               : WhenOpened::kClose;
}

/// Lets the traces of strokes that the edit divides, joins or removes follow the longest remainder;
/// removes them if there is none.
void let_traces_follow(const Document& document, Edit& edit) {
  std::vector<GuideChange> changes;
  for (const auto& [id, guide] : document.guides()) {
    const bool is_changed = std::any_of(edit.guides.begin(), edit.guides.end(),
                                        [id = id](const GuideChange& c) { return c.id == id; });
    const auto stroke = std::find_if(
        edit.changes.begin(), edit.changes.end(),
        [&guide = guide](const StrokeChange& c) { return guide->stroke && c.id == guide->stroke; });
    if (is_changed || stroke == edit.changes.end() || stroke->before == stroke->after) continue;
    const StrokeId remainder = longest_remainder(edit, guide->stroke);
    if (remainder == guide->stroke) continue;
    DrawingGuidePtr after;
    if (remainder) {
      DrawingGuide followed = *guide;
      followed.stroke = remainder;
      after = std::make_shared<const DrawingGuide>(std::move(followed));
    }
    changes.push_back({id, guide, std::move(after)});
  }
  edit.guides.insert(edit.guides.end(), changes.begin(), changes.end());
}

/// Returns true if the edit adds a stroke or fill to the layer.
bool adds_ink(const Edit& edit, LayerId layer) {
  const auto adds = [layer](const auto& change) {
    return !change.before && change.after && change.after_place.layer == layer;
  };
  return std::any_of(edit.changes.begin(), edit.changes.end(), adds) ||
         std::any_of(edit.fills.begin(), edit.fills.end(), adds);
}

}  // namespace

Result<void> Session::take(ToolResult result) {
  // A commit also replaces the preview, because a preview of the previous document is invalid.
  if (result.preview || result.commit || !result.same_preview) show(std::move(result.preview));
  Result<void> done;
  if (!result.commit) result.offer.reset();  // an offer belongs to a step
  if (result.commit) {
    gesture_is_open_ = false;
    const Edit drawn = *result.commit;
    let_others_follow(*result.commit, Origin::kTool);
    done = apply_and_record(*std::move(result.commit));
    as_drawn_.reset();
    if (done && result.as_drawn) {
      as_drawn_ = AsDrawn{std::move(*result.as_drawn), history_.position()};
    }
    if (done) offer_exact(drawn);
  }
  if (done && result.selection) {
    set_selection(std::move(*result.selection));
  }
  if (done && result.offer) {
    offer_ = std::move(result.offer);
    offer_edits_ = edits_;
  }
  if (done && result.refusal) return refusals_.add(*std::move(result.refusal));
  if (!done) {
    return tl::unexpected(with_context(done.error(), std::string(tool().info().id)));
  }
  return done;
}

void Session::show(std::optional<Edit> preview) {
  // The preview of a gesture may remain for a while after the touch. The preview of a hovering pen
  // begins without a touch.
  preview_is_of_gesture_ = preview && (gesture_is_open_ || preview_is_of_gesture_);
  preview_ = std::move(preview);
  shown_is_current_ = false;
}

Result<void> Session::commit(Edit edit) {
  let_others_follow(edit, Origin::kCommand);
  return apply_and_record(std::move(edit));
}

Result<void> Session::apply_and_record(Edit edit) {
  if (edit.empty()) return {};
  if (Result<void> applied = document_.apply(edit); !applied) return applied;
  follow(edit);
  // While this is the newest step, the layer that it added is still the highest.
  const bool has_new_layer =
      ink_layer_step_ == history_.position() && adds_ink(edit, document_.layers().back().id);
  if (!has_new_layer || !history_.join(edit)) history_.record(std::move(edit));
  return {};
}

Result<void> Session::commit_with_previous(Edit edit) {
  let_others_follow(edit, Origin::kCommand);
  if (Result<void> applied = document_.apply(edit); !applied) return applied;
  follow(edit);
  if (!history_.extend(edit)) history_.record(std::move(edit));
  return {};
}

bool Session::draws_ink() const noexcept {
  const ToolKind kind = tool().info().kind;
  return kind == ToolKind::kDraws || kind == ToolKind::kShapes;
}

void Session::let_others_follow(Edit& edit, Origin origin) const {
  let_images_follow(document_, edit);
  if (origin == Origin::kTool && draws_ink()) {
    if (const DrawingGuide* guide = symmetry()) add_images(document_, *guide, edit);
  }
  let_traces_follow(document_, edit);
  let_fills_follow(edit);
}

void Session::let_fills_follow(Edit& edit) const {
  if (document_.fill_count() == 0) {
    fill_map_.reset();
    return;
  }
  if (edit.changes.empty()) return;
  if (!fill_map_) fill_map_ = std::make_unique<DocumentMap>(DocumentMap::Of::kAllStrokes);
  std::vector<FillChange> fills = following_fills(document_, edit, *fill_map_, when_opened(*this));
  std::move(fills.begin(), fills.end(), std::back_inserter(edit.fills));
}

const std::optional<Edit>& Session::preview_with_fills() const {
  if (!shown_is_current_) {
    shown_preview_ = preview_;
    if (shown_preview_) let_others_follow(*shown_preview_, Origin::kTool);
    shown_is_current_ = true;
  }
  return shown_preview_;
}

}  // namespace felt
