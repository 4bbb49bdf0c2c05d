#include "felt/session/timing_edit.h"

#include <algorithm>
#include <string>
#include <utility>

namespace felt {
namespace {

KeyTiming changed_timing(const KeyTimingPtr& present, const TimingEvent& event) {
  KeyTiming timing = timing_or_default(present);
  timing.between = event.between.value_or(timing.between);
  timing.hold = event.hold.value_or(timing.hold);
  timing.ease = event.ease.value_or(timing.ease);
  if (event.pairs) timing.pairs = *event.pairs;
  return timing;
}

}  // namespace

Result<Edit> timing_edit(const Document& document, const TimingEvent& event) {
  if (event.layers.empty()) return fail(ErrorCode::kInvalidArgument, "ids: there is no layer");
  for (const LayerId id : event.layers) {
    if (!document.layer(id)) {
      return fail(ErrorCode::kNotFound, "no layer " + std::to_string(id.value));
    }
  }
  Edit edit{event.pairs ? "Correct matches" : "Motion timing", {}};
  const auto layers = document.layers();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Layer& layer = layers[i];
    if (std::find(event.layers.begin(), event.layers.end(), layer.id) == event.layers.end()) {
      continue;
    }
    KeyTiming timing = changed_timing(layer.timing, event);
    if (Result<void> fine = check_key_timing(timing); !fine) return tl::unexpected(fine.error());
    LayerState after = layer.state();
    after.timing = shared_timing(std::move(timing));
    if (equal_timings(after.timing, layer.timing)) continue;
    edit.layers.push_back({layer.id, layer.state(), std::move(after), i, i});
  }
  return edit;
}

Result<Edit> body_edit_edit(const Document& document, const BodyEvent& event) {
  if (event.what == BodyEvent::Do::kClear) {
    Edit edit{"Remove edits of the body", {}};
    for (const auto& [id, present] : document.body_edits()) {
      edit.body_edits.push_back({id, present, nullptr});
    }
    return edit;
  }
  if (event.what == BodyEvent::Do::kRemove) {
    const BodyEditPtr present = document.find_body_edit(event.id);
    if (!present) {
      return fail(ErrorCode::kNotFound, "id: no body edit " + std::to_string(event.id.value));
    }
    Edit edit{"Remove edit of the body", {}};
    edit.body_edits.push_back({event.id, present, nullptr});
    return edit;
  }
  if (Result<void> fine = check_body_edit(event.edit); !fine) return tl::unexpected(fine.error());
  if (document.body_edits().size() >= kMaxBodyEdits) {
    return fail(ErrorCode::kLimitExceeded, "body: a drawing has at most 1000 edits of its body");
  }
  Edit edit{"Edit the body", {}};
  edit.body_edits.push_back(
      {document.new_body_edit_id(), nullptr, std::make_shared<const BodyEdit>(event.edit)});
  return edit;
}

}  // namespace felt
