#include "felt/tools/gesture_tool.h"

#include <utility>

namespace felt {
namespace {

/// Removes replacements that leave a stroke unchanged. An edit without changes is not committed, so
/// it does not make an undo step.
void leave_out_unchanged(std::optional<Edit>& commit) {
  if (!commit) return;
  std::erase_if(commit->changes, [](const StrokeChange& c) {
    return c.before && c.after && c.before_place == c.after_place && *c.before == *c.after;
  });
  if (commit->empty()) commit.reset();
}

}  // namespace

GestureTool::GestureTool(const ToolInfo& info) : info_(info), options_(info.options) {
  gap_.reserve(Contact::kMaxGapSamples);
}

ToolResult GestureTool::sample(const PenSample& sample, Contact::Change contact,
                               const Scene& scene) {
  if (!in_gesture_ && std::exchange(has_new_options_, false)) take_options(options_);
  is_down_ = contact != Contact::Change::kAir && contact != Contact::Change::kLifted;
  if (!is_down_) {
    waiting_ = false;
    return in_gesture_ ? close(scene) : hover(sample, scene);
  }
  if (contact == Contact::Change::kTouched && !waiting_) {
    in_gesture_ = true;
    gap_.clear();
    return begin(sample, scene);
  }
  return in_gesture_ ? add(sample, scene) : ToolResult{};
}

ToolResult GestureTool::add(const PenSample& sample, const Scene& scene) {
  if (!in_contact(sample)) {
    gap_.push_back(sample);
    return {.same_preview = true};
  }
  ToolResult result{.same_preview = true};
  const auto take = [&](const PenSample& s) {
    ToolResult next = move(s, scene);
    if (next.preview) result.preview = std::move(next.preview);
    if (next.selection) result.selection = std::move(next.selection);
    if (next.refusal) result.refusal = std::move(next.refusal);
  };
  for (const PenSample& between : gap_) take(between);
  gap_.clear();
  take(sample);
  return result;
}

ToolResult GestureTool::close(const Scene& scene) {
  ToolResult result = end(scene);
  leave_out_unchanged(result.commit);
  stop();
  return result;
}

void GestureTool::stop() {
  in_gesture_ = false;
  gap_.clear();
}

ToolResult GestureTool::finish(const Scene& scene) {
  // The next sample may have any position and time. If the pen is in a gap, it counts as lifted.
  waiting_ = is_down_ && gap_.empty();
  is_down_ = false;
  if (in_gesture_) return close(scene);
  stop_hovering();
  return {};
}

void GestureTool::cancel() {
  waiting_ = is_down_;
  if (!in_gesture_) return stop_hovering();
  drop();
  stop();
}

Result<void> GestureTool::set_option(std::string_view id, const OptionValue& value) {
  Result<void> result = options_.set(id, value);
  if (!result) return result;
  has_new_options_ = true;
  if (!in_gesture_ && std::exchange(has_new_options_, false)) take_options(options_);
  return result;
}

Result<OptionValue> GestureTool::option(std::string_view id) const {
  return options_.get(id);
}

double seconds_between(std::int64_t from_ns, std::int64_t to_ns, double max_s) noexcept {
  // Computed in double, because the difference of two invalid times may overflow 64 bits.
  const double ns = static_cast<double>(to_ns) - static_cast<double>(from_ns);
  return std::clamp(1e-9 * ns, 0.0, max_s);
}

}  // namespace felt
