#include "felt/autosave/live_ink.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "felt/io/events/event_writer.h"
#include "felt/material/material_file.h"
#include "felt/store/byte_writer.h"

namespace felt {
namespace {

constexpr std::size_t kMaxScriptBytes = std::size_t{1} << 20;  // of a context
constexpr std::size_t kMaxMarks = std::size_t{1} << 26;
constexpr std::size_t kMaxOverhang = std::size_t{1} << 20;  // 17 min at 1 kHz
constexpr std::size_t kSampleBytes = 8 + 4 * 8 + 4;
constexpr std::size_t kLeaningBytes = kSampleBytes + 8;
constexpr std::size_t kMinSelectedBytes = 12;

/// Returns the value, or NaN if it is missing.
double number_or_nan(std::optional<double> value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}
std::optional<double> unless_nan(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

void append_sample(ByteWriter& out, const PenSample& sample, LiveKind kind) {
  out.u64(static_cast<std::uint64_t>(sample.time_ns));
  out.f64(sample.position.x);
  out.f64(sample.position.y);
  out.f64(sample.position.z);
  out.f64(number_or_nan(sample.pressure));
  out.u32(sample.buttons);
  if (kind == LiveKind::kTilted) out.f64(number_or_nan(sample.tilt_deg));
}

PenSample read_sample(ByteReader& in, LiveKind kind) {
  PenSample sample;
  sample.time_ns = static_cast<std::int64_t>(in.u64());
  sample.position = {in.f64(), in.f64(), in.f64()};
  sample.pressure = unless_nan(in.f64());
  sample.buttons = in.u32();
  if (kind == LiveKind::kTilted) sample.tilt_deg = unless_nan(in.f64());
  return sample;
}

}  // namespace

void LiveInk::clear() {
  close();
  options_.clear();
  materials_.clear();
  tool_.clear();
  layer_ = {};
  selection_ = {};
  hover_.clear();
  overhang_.clear();
  contact_ = {};
  has_ended_ = ring_is_open_ = false;
  events_ring_ = loop_ring_ = {};
}

bool LiveInk::RingTouch::holds(bool ring_is_open, const PenSample& sample) noexcept {
  if (!ring_is_open && !is_held_) return false;
  contact_.update(sample);
  is_held_ = contact_.is_down();
  return ring_is_open || is_held_;
}

/// Opens or closes the ring as Session does: it does not open during a gesture, and the choice of a
/// tool closes it.
void LiveInk::follow_ring(const Event& event, bool gesture_in_progress) {
  const auto* ring = std::get_if<UseRing>(&event.what);
  if (ring && ring->is_open && !gesture_in_progress) {
    close();
    hover_.clear();
    overhang_.clear();
    ring_is_open_ = true;
  } else if ((ring && !ring->is_open) || std::holds_alternative<SelectTool>(event.what)) {
    ring_is_open_ = false;
  }
}

void LiveInk::add_context(const Event& event) {
  if (const auto* tool = std::get_if<SelectTool>(&event.what)) tool_ = tool->id;
  if (const auto* option = std::get_if<SetOption>(&event.what))
    options_[option->id] = option->value;
  if (const auto* device = std::get_if<UseDevice>(&event.what)) device_ = *device;
  if (const auto* used = std::get_if<UseMaterial>(&event.what)) {
    if (const Result<AnyMaterial> material = read_material(used->text)) {
      materials_[material_key(*material)] = used->text;
    }
  }
  if (const auto* layer = std::get_if<LayerEvent>(&event.what)) {
    if (layer->what == LayerEvent::Do::kUse) layer_ = layer->layer;
  }
  if (const auto* view = std::get_if<UseView>(&event.what)) view_ = *view;
}

void LiveInk::event_applied(const Event& event, bool gesture_in_progress) {
  const auto* pen = std::get_if<PenEvent>(&event.what);
  if (!pen) {  // may be newer than samples that the session has not received yet
    add_context(event);
    follow_ring(event, gesture_in_progress);
    if (open_) append_event_line(events_, event);
    return;
  }
  // Without a sample before the stretch, kNoEditNs counts from this one.
  if (session_ns_ == INT64_MIN) last_contact_ns_ = event.time_ns;
  session_ns_ = std::max(session_ns_, event.time_ns);
  while (!overhang_.empty() && overhang_.front().time_ns <= session_ns_) overhang_.pop_front();
  PenSample sample = sample_of(event.time_ns, *pen);
  if (events_ring_.holds(ring_is_open_, sample)) {
    lift(sample);
    contact_.update(sample);
    has_ended_ = has_ended_ && contact_.is_down();
    return;
  }
  const bool touches = contact_.update(sample) == Contact::Change::kTouched;
  if (touches && !open_) open();
  if (contact_.is_down()) last_contact_ns_ = event.time_ns;
  // The rest of a contact whose gesture has ended draws nothing and must not be saved as another
  // gesture, not even if the overhang has started the next stretch already.
  has_ended_ = has_ended_ && contact_.is_down();
  if (has_ended_) return hover_.clear();
  if (contact_.is_down()) {
    hover_.clear();
  } else {  // also in a stretch, which an edit before its contact closes
    hover_.push_back(event);
    if (hover_.size() > kHoverSamples) hover_.pop_front();
  }
  if (!open_) return;
  append_event_line(events_, event);
  if (event.time_ns - last_contact_ns_ > kNoEditNs && !gesture_in_progress) close();
}

void LiveInk::edit_applied(const Edit& edit) {
  close();
  has_ended_ = contact_.is_down();
  // The edit that adds the layer of a line comes before its first sample in contact.
  if (!edit.changes.empty() || !edit.fills.empty()) hover_.clear();
}

void LiveInk::add_loop_sample(const PenSample& sample) {
  if (loop_ring_.holds(ring_is_open_, sample)) return;
  if (sample.time_ns > session_ns_ && overhang_.size() < kMaxOverhang) overhang_.push_back(sample);
}

/// Returns true if an option has selected the material with this key.
bool LiveInk::is_chosen(std::string_view key) const {
  const std::string_view id = key.substr(key.find(' ') + 1);
  return std::any_of(options_.begin(), options_.end(), [&](const auto& option) {
    const auto* text = std::get_if<std::string>(&option.second);
    return text && *text == id;
  });
}

/// Starts a stretch. Its first chunk has all state besides the document on which the ink of the
/// gesture depends: events and the selection.
void LiveInk::open() {
  open_ = true;
  const std::int64_t time_ns = hover_.empty() ? 0 : hover_.front().time_ns;
  std::string script;
  const auto add = [&](decltype(Event::what) what) {
    append_event_line(script, {time_ns, std::move(what)});
  };
  if (device_) add(*device_);
  if (!tool_.empty()) add(SelectTool{tool_});
  for (const auto& [key, text] : materials_) {
    if (is_chosen(key)) add(UseMaterial{text});
  }
  for (const auto& [id, value] : options_) add(SetOption{id, value});
  if (layer_) add(LayerEvent{LayerEvent::Do::kUse, layer_, {}});
  if (!view_.hidden.empty()) add(view_);
  for (const Event& event : hover_) append_event_line(script, event);
  context_.clear();
  ByteWriter out(context_);
  out.text(script);
  out.u32(static_cast<std::uint32_t>(selection_.strokes().size()));
  for (const auto& [id, marks] : selection_.strokes()) {
    out.u64(id.value);
    out.text({reinterpret_cast<const char*>(marks.data()), marks.size()});
  }
  // If the stretch has no contact yet, kNoEditNs counts from the session's last sample.
  last_contact_ns_ = std::max(last_contact_ns_, session_ns_);
}

void LiveInk::close() {
  if (open_ || !chunks_.empty()) clear_ = true;
  open_ = false;
  context_.clear();
  events_.clear();
  chunks_.clear();
  bytes_ = 0;
  kept_ns_ = INT64_MIN;
}

/// Returns true if the pen touches the surface in the overhang. If so, removes the samples of the
/// overhang that belong to a gesture that has ended.
bool LiveInk::overhang_touches() {
  Contact contact = contact_;
  std::size_t over = 0;
  for (std::size_t i = 0; i < overhang_.size(); ++i) {
    if (contact.update(overhang_[i]) == Contact::Change::kTouched) {
      overhang_.erase(overhang_.begin(), overhang_.begin() + static_cast<std::ptrdiff_t>(over));
      return true;
    }
    if (contact.is_down()) over = i + 1;
  }
  return false;
}

void LiveInk::keep(Changes& changes, LiveKind kind, std::string bytes) {
  if (bytes_ + bytes.size() > kMaxBytes) return;
  bytes_ += bytes.size();
  chunks_.push_back({kind, std::move(bytes)});
  changes.chunks.push_back(chunks_.back());
}

LiveInk::Changes LiveInk::take_changes() {
  if (!open_) {
    if (overhang_touches()) {
      open();
    } else {
      while (overhang_.size() > kHoverSamples) overhang_.pop_front();
    }
  }
  Changes changes;
  changes.clear = std::exchange(clear_, false);
  if (!open_) return changes;
  if (!context_.empty()) keep(changes, LiveKind::kContext, std::exchange(context_, {}));
  if (!events_.empty()) keep(changes, LiveKind::kEvents, std::exchange(events_, {}));
  std::string samples;
  ByteWriter out(samples);
  const bool tilts = std::any_of(overhang_.begin(), overhang_.end(), [](const PenSample& sample) {
    return sample.tilt_deg.has_value();
  });
  const LiveKind kind = tilts ? LiveKind::kTilted : LiveKind::kSamples;
  for (const PenSample& sample : overhang_) {
    if (sample.time_ns > kept_ns_) append_sample(out, sample, kind);
  }
  if (!overhang_.empty()) kept_ns_ = std::max(kept_ns_, overhang_.back().time_ns);
  if (!samples.empty()) keep(changes, kind, std::move(samples));
  return changes;
}

Result<void> read_live_chunk(LiveKind kind, std::string_view bytes, LiveStretch& stretch) {
  const auto damaged = [] {
    return fail(ErrorCode::kInvalidData, "the unfinished gesture is damaged");
  };
  if (kind == LiveKind::kEvents) {
    stretch.script += bytes;
    return {};
  }
  ByteReader in(bytes);
  if (kind == LiveKind::kSamples || kind == LiveKind::kTilted) {
    if (bytes.size() % (kind == LiveKind::kTilted ? kLeaningBytes : kSampleBytes) != 0) {
      return damaged();
    }
    while (in.left() > 0) stretch.overhang.push_back(read_sample(in, kind));
    return {};
  }
  if (kind != LiveKind::kContext) return damaged();
  stretch.script = std::string(in.text(kMaxScriptBytes));
  const std::uint32_t count = in.u32();
  if (!in.has(count, kMinSelectedBytes)) return damaged();
  for (std::uint32_t i = 0; i < count; ++i) {
    const StrokeId id{in.u64()};
    const std::string_view marks = in.text(kMaxMarks);
    if (in.ok()) stretch.selection.set(id, {marks.begin(), marks.end()});
  }
  if (!in.ok() || in.left() > 0) return damaged();
  return {};
}

}  // namespace felt
