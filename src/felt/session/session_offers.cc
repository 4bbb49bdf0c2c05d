// The offers of a session: what the last stroke could mean besides ink.
#include <algorithm>
#include <utility>

#include "felt/session/session.h"

namespace felt {

std::optional<OfferView> Session::offered() const {
  if (gesture_in_progress()) return tool().offered();
  if (!has_offer()) return std::nullopt;
  OfferView view{offer_->at, {}, offer_->chosen};
  for (const OfferChoice& choice : offer_->choices)
    view.rows.push_back({choice.kind, choice.count});
  return view;
}

Result<void> Session::choose(OfferKind what) {
  if (gesture_in_progress()) {
    tools_[active_]->choose(what);
    return {};
  }
  if (!has_offer()) return {};
  const auto found =
      std::find_if(offer_->choices.begin(), offer_->choices.end(),
                   [what](const OfferChoice& choice) { return choice.kind == what; });
  if (found == offer_->choices.end()) return {};
  OfferChoice wanted = *found;
  const OfferChoice present = offer_->choices[offer_->chosen];
  if (Result<void> settled = settle(); !settled) return settled;
  offer_.reset();
  if (wanted.kind == present.kind) return {};
  // The edits of all choices fit the document before the stroke.
  if (!present.edit.empty()) {
    const Result<Edit> undone = history_.undo(document_);
    if (!undone) return tl::unexpected(undone.error());
    follow(*undone);
    // If the step of the stroke has also added its layer, the other choice needs the same one.
    if (!undone->layers.empty() && !wanted.edit.empty()) {
      Edit layer{undone->label, {}, undone->inverse().layers};
      if (Result<void> done = apply_and_record(std::move(layer)); !done) return done;
      ink_layer_step_ = history_.position();
    }
  }
  // Like the edit of the stroke, the new ink gets mirror images.
  let_others_follow(wanted.edit, Origin::kTool);
  if (Result<void> done = apply_and_record(std::move(wanted.edit)); !done) return done;
  if (wanted.selection) set_selection(std::move(*wanted.selection));
  return {};
}

void Session::draw_offer(Overlay& overlay) const {
  if (gesture_in_progress() || !has_offer()) return;
  for (std::size_t i = 0; i < offer_->choices.size(); ++i) {
    const OfferChoice& choice = offer_->choices[i];
    if (i == offer_->chosen || choice.kind == OfferKind::kInk) continue;
    for (const StrokeChange& change : choice.edit.changes) {
      if (choice.kind == OfferKind::kDelete && change.before) {
        add_span(overlay, *change.before, 0.0, change.before->segment_count(), Overlay::Role::kCut);
      } else if (choice.kind != OfferKind::kDelete && change.after) {
        add_span(overlay, *change.after, 0.0, change.after->segment_count(), Overlay::Role::kGuide);
      }
    }
    if (!choice.selection) continue;
    for (const auto& [id, marks] : choice.selection->strokes()) {
      const StrokePtr stroke = document_.find(id);
      if (stroke) {
        add_span(overlay, *stroke, 0.0, stroke->segment_count(), Overlay::Role::kSelected);
      }
    }
  }
}

}  // namespace felt
