// The guides of the drawing in an episode: random guides, and strokes that become exact.
#include <algorithm>
#include <iterator>
#include <string>

#include "tests/drawing/gestures/episode.h"
#include "tests/drawing/gestures/random_guide.h"

namespace felt::gestures {
namespace {

constexpr std::size_t kGuideActions = static_cast<std::size_t>(GuidesEvent::Do::kUnlink) + 1;

}  // namespace

/// Adds, changes, removes, shows or hides guides, or unlinks mirrored strokes. It is at most one
/// undo step; a guide that does not exist is refused and changes nothing.
void Episode::change_guides() {
  using Do = GuidesEvent::Do;
  const Document& document = session_.document();
  GuidesEvent event;
  event.what = dice_.chance(0.4) ? Do::kAdd : static_cast<Do>(dice_.pick(kGuideActions));
  const bool names_guide = event.what == Do::kChange || event.what == Do::kRemove;
  if (names_guide && !document.guides().empty()) {
    const auto skipped = static_cast<std::ptrdiff_t>(dice_.pick(document.guides().size()));
    event.id = std::next(document.guides().begin(), skipped)->first;
  }
  if (event.what == Do::kAdd || event.what == Do::kChange) {
    event.guide = random_guide(dice_, document);
  }
  where_ += ", guides " + std::to_string(static_cast<int>(event.what));
  const bool is_fine = (!names_guide || event.id) &&
                       (event.what != Do::kAdd || document.guides().size() < kMaxDrawingGuides);
  const bool is_ignored = session_.gesture_in_progress();
  const std::uint64_t edits = edits_;
  is_command_ = true;
  const Result<void> done = session_.apply({now_ns_, event});
  is_command_ = false;
  if (is_fine != done.has_value() && !is_ignored) {
    break_rule("guides: " + (done ? "accepted wrongly" : "refused: " + done.error().message));
  }
  if (edits_ != edits && (!done || is_ignored)) break_rule("guides: changed what they must not");
  if (event.what == Do::kAdd && is_fine && !is_ignored && !session_.document().shows_guides()) {
    break_rule("a new guide is hidden");
  }
  break_rule(check_selection(session_.document(), session_.selection()));
}

/// Makes the last stroke exact, if that is offered; otherwise it must change nothing.
void Episode::make_exact() {
  const StrokePtr offer = session_.exact_offer();
  where_ += offer ? ", exact" : ", exact without an offer";
  const std::uint64_t edits = edits_;
  const std::size_t steps = session_.history().undo_count();
  command(ExactEvent{});
  if (broken_) return;
  // Ink that waits for a bounce is committed first, and may then be made exact.
  const std::size_t most = steps + (offer ? 1 : 2);
  if (session_.history().undo_count() > most) break_rule("exact: more than one step");
  if (session_.exact_offer()) break_rule("exact: still offered");
  if (!offer || edits_ == edits) return;
  ++totals_.exact;
  const auto& layers = session_.document().layers();
  const bool is_there = std::any_of(layers.begin(), layers.end(), [&](const Layer& layer) {
    return std::any_of(layer.strokes.begin(), layer.strokes.end(),
                       [&](StrokeId id) { return *session_.document().find(id) == *offer; });
  });
  if (!is_there) break_rule("exact: not the stroke that was offered");
}

}  // namespace felt::gestures
