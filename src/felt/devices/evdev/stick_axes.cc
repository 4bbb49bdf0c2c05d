#include "felt/devices/evdev/stick_axes.h"

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace felt {
namespace {

constexpr int kExtraButtons = 2;

double to_double(std::int32_t value) noexcept {
  return static_cast<double>(value);
}

}  // namespace

double StickAxes::Axis::centered() const noexcept {
  const double middle = 0.5 * (to_double(minimum) + to_double(maximum));
  const double half = 0.5 * (to_double(maximum) - to_double(minimum));
  const double dead = std::clamp(to_double(flat), 0.0, 0.5 * half);
  const double off = std::clamp(to_double(value), to_double(minimum), to_double(maximum)) - middle;
  const double beyond = std::max(std::abs(off) - dead, 0.0);
  return std::copysign(beyond / (half - dead), off);
}

double StickAxes::Axis::share() const noexcept {
  return std::clamp(
      (to_double(value) - to_double(minimum)) / (to_double(maximum) - to_double(minimum)), 0.0,
      1.0);
}

StickStand ask_stick(EvdevPort& port, const StickLayout& layout) noexcept {
  StickStand stand;
  const auto ask = [&](std::uint16_t code, EvdevAxis& axis) {
    if (stand.error != 0) return;
    const auto info = port.axis(code);
    if (info) axis = *info;
    stand.error = !info ? info.error() : axis.maximum > axis.minimum ? 0 : EINVAL;
  };
  ask(layout.x, stand.x);
  if (layout.y) ask(*layout.y, stand.y);
  if (layout.pressure) ask(*layout.pressure, stand.pressure);
  for (int i = 0; stand.error == 0 && i <= kExtraButtons; ++i) {
    const auto is_down = port.key(static_cast<std::uint16_t>(layout.contact + i));
    if (!is_down) {
      stand.error = is_down.error();
    } else if (i == 0) {
      stand.touches = *is_down;
    } else if (*is_down) {
      stand.buttons |= 1U << (i - 1);
    }
  }
  return stand;
}

void StickAxes::put(const StickStand& stand) noexcept {
  x_.take(stand.x);
  if (layout_.y) y_.take(stand.y);
  if (layout_.pressure) lever_.take(stand.pressure);
  touches_ = stand.touches;
  buttons_ = stand.buttons;
}

tl::expected<void, int> StickAxes::begin(const StickStand& stand) noexcept {
  if (stand.error != 0) return tl::unexpected(stand.error);
  put(stand);
  from_ = to_ = now_ = said();
  return {};
}

tl::expected<void, int> StickAxes::take(const StickStand& stand, std::int64_t now_ns) noexcept {
  if (stand.error != 0) return tl::unexpected(stand.error);
  loss_ = Loss::kNone;
  put(stand);
  report(now_ns);
  return {};
}

bool StickAxes::is_stale(std::int64_t now_ns) const noexcept {
  return needs_asking() && (now_ns - lost_ns_ > kStaleNs || now_ns < lost_ns_);
}

StickAxes::Said StickAxes::said() const noexcept {
  Said said;
  said.x_mm = layout_.half_way_mm * x_.centered();
  said.y_mm = layout_.y ? layout_.half_way_mm * y_.centered() : 0.0;
  said.touches = touches_;
  said.buttons = buttons_;
  if (touches_) {
    said.pressure = layout_.pressure ? std::max(lever_.share(), kMinPressure) : kUsualPressure;
  }
  return said;
}

void StickAxes::receive(const EvdevEvent& event) noexcept {
  if (event.type == evdev::kAbs) {
    if (event.code == layout_.x) x_.value = event.value;
    if (layout_.y && event.code == *layout_.y) y_.value = event.value;
    if (layout_.pressure && event.code == *layout_.pressure) lever_.value = event.value;
  }
  if (event.type != evdev::kKey || event.value > 1) return;  // 2 is auto-repeat
  const int button = event.code - layout_.contact;
  if (button == 0) touches_ = event.value != 0;
  if (button < 1 || button > kExtraButtons) return;
  const std::uint32_t bit = 1U << (button - 1);
  buttons_ = event.value != 0 ? buttons_ | bit : buttons_ & ~bit;
}

void StickAxes::glide_to(std::int64_t now_ns) noexcept {
  const double passed_ns = static_cast<double>(now_ns) - static_cast<double>(from_ns_);
  const double share = std::clamp(passed_ns / static_cast<double>(kGlideNs), 0.0, 1.0);
  if (share >= 1.0) {
    now_ = to_;
    return;
  }
  now_.x_mm = std::lerp(from_.x_mm, to_.x_mm, share);
  now_.y_mm = std::lerp(from_.y_mm, to_.y_mm, share);
}

void StickAxes::report(std::int64_t now_ns) noexcept {
  glide_to(now_ns);
  const Said newest = said();
  // The position may still be on its way to the previous report when the next one comes. If that
  // report had a touch or lift and the next one reverts it, the touch or lift must not be lost, so
  // it takes effect now.
  if (newest.touches != to_.touches && now_.touches != to_.touches) {
    now_.touches = to_.touches;
    now_.pressure = to_.pressure;
  }
  to_ = newest;
  from_ = has_sampled_ ? now_ : to_;  // the first report takes effect immediately
  from_ns_ = now_ns;
}

tl::expected<void, int> StickAxes::listen(EvdevPort& port, std::int64_t now_ns) noexcept {
  EvdevEvent event;
  // While needs_asking() is true, events stay unread. They are newer than the state that the worker
  // will return, or agree with it.
  for (int i = 0; i < kMaxEvents && !needs_asking(); ++i) {
    const auto more = port.next(event);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    const bool is_end = event.type == evdev::kSyn && event.code == evdev::kSynReport;
    if (event.type == evdev::kSyn && event.code == evdev::kSynDropped) loss_ = Loss::kSkips;
    if (loss_ == Loss::kSkips) {
      // Events up to the end of the current report are incomplete, because some of them were lost.
      if (!is_end) continue;
      loss_ = Loss::kAsks;
      lost_ns_ = now_ns;
    } else {
      receive(event);
      if (is_end) report(now_ns);
    }
  }
  return {};
}

PenSample StickAxes::sample(std::int64_t now_ns) noexcept {
  glide_to(now_ns);
  PenSample pen;
  pen.time_ns = now_ns;
  pen.position = {now_.x_mm, now_.y_mm, now_.touches ? -kDepthMm * now_.pressure : kHoverMm};
  pen.pressure = now_.touches ? now_.pressure : 0.0;
  pen.buttons = now_.buttons;
  const double passed_s =
      has_sampled_ ? 1e-9 * (static_cast<double>(now_ns) - static_cast<double>(sampled_ns_)) : 0.0;
  constexpr double kGapS = 0.1;
  if (passed_s < 0.0 || passed_s > kGapS) velocity_.reset();
  const Vec3 in_plane{pen.position.x, pen.position.y, 0.0};
  pen.velocity = velocity_.update(in_plane, passed_s);
  has_sampled_ = true;
  sampled_ns_ = now_ns;
  return pen;
}

double StickAxes::step_mm() const noexcept {
  return 2.0 * layout_.half_way_mm / (to_double(x_.maximum) - to_double(x_.minimum));
}

}  // namespace felt
