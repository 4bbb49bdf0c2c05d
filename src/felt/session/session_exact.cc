// Exact strokes: a stroke that kept to a guide of the drawing can become a line or an arc.
#include <memory>
#include <utility>

#include "felt/session/layer_edit.h"
#include "felt/session/session.h"
#include "felt/tools/exact_ink.h"
#include "felt/tools/stroke_guide.h"

namespace felt {

StrokePtr Session::exact_offer() const {
  if (!exact_ || gesture_in_progress()) return {};
  if (document_.find(exact_->id) != exact_->drawn) return {};
  const Layer* layer = document_.layer(document_.layer_of(exact_->id));
  return layer && is_open(*layer) ? exact_->exact : StrokePtr();
}

std::uint64_t Session::guide_ticks() const noexcept {
  return stroke_guide_->ticks();
}

void Session::draw_guide_spring(Overlay& overlay) const {
  stroke_guide_->draw_spring(overlay);
}

/// Offers an exact curve if the edit adds one stroke and changes no other.
void Session::offer_exact(const Edit& drawn) {
  exact_.reset();
  if (tool().info().kind != ToolKind::kDraws || drawn.changes.size() != 1) return;
  const StrokeChange& ink = drawn.changes.front();
  const std::optional<ExactPath> path = stroke_guide_->exact_path();
  if (ink.before || !ink.after || !path) return;
  if (std::optional<ExactOffer> offer = offer_exact_ink(document_, scene().index, ink.id, *path)) {
    exact_ = std::make_unique<ExactOffer>(*std::move(offer));
  }
}

Result<void> Session::make_exact() {
  if (gesture_in_progress()) return {};
  if (Result<void> settled = settle(); !settled) return settled;
  if (!exact_offer()) return {};
  Edit edit = exact_edit(document_, scene().index, *exact_);
  exact_.reset();
  return edit.empty() ? Result<void>() : commit(std::move(edit));
}

}  // namespace felt
