#include "felt/stroke/fit/pen_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt {
namespace {

/// The samples of a stray start lie within this distance of the first one.
constexpr double kStrayStartMm = 1.0;

bool is_real(const std::optional<double>& pressure) {
  return pressure && *pressure > 0.0;
}

template <class T>
void drop_front(std::vector<T>& v, std::size_t count) {
  v.erase(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

PenFilter::PenFilter(const PenFilterOptions& options) : options_(options) {
  held_.reserve(kMaxHeld + 1);
  held_ms_.reserve(kMaxHeld + 1);
  released_.reserve(kMaxHeld + 1);
}

void PenFilter::begin() noexcept {
  held_.clear();
  held_ms_.clear();
  released_.clear();
  last_released_.reset();
  last_time_ns_.reset();
  now_ms_ = 0.0;
}

std::span<const InkSample> PenFilter::push(const InkSample& sample) {
  released_.clear();
  advance_clock(sample);
  held_.push_back(sample);
  held_ms_.push_back(now_ms_);
  drop_stray();
  std::size_t due = count_due();
  if (due > 0 && !last_released_) {
    // A stray start is known only when two samples have followed it.
    if (held_.size() == 2 && is_jump(0, 1)) return released_;
    drop_stray_start();
    due = count_due();
    if (due > 0) mend_start(true);
  }
  release(due);
  return released_;
}

// Returns the number of held samples that have waited for one window.
std::size_t PenFilter::count_due() const noexcept {
  std::size_t due = held_.size() > kMaxHeld ? held_.size() - kMaxHeld : 0;
  while (due < held_.size() && held_ms_[due] + options_.window_ms < now_ms_) ++due;
  return due;
}

std::span<const InkSample> PenFilter::end() {
  released_.clear();
  if (last_released_) {
    mend_end();
  } else {
    drop_stray_start();
    mend_start(false);
  }
  release(held_.size());
  return released_;
}

void PenFilter::advance_clock(const InkSample& sample) noexcept {
  double dt_ms = held_.empty() && !last_released_ ? 0.0 : options_.interval_ms;
  if (sample.time_ns && last_time_ns_) {
    dt_ms = (static_cast<double>(*sample.time_ns) - static_cast<double>(*last_time_ns_)) * 1e-6;
  }
  last_time_ns_ = sample.time_ns;
  now_ms_ += std::max(dt_ms, 0.0);
}

bool PenFilter::is_jump(std::size_t from, std::size_t to) const noexcept {
  const double dt_s = (held_ms_[to] - held_ms_[from]) * 1e-3;
  return distance(held_[from].position, held_[to].position) >
         std::max(options_.jump_mm, options_.jump_mm_per_s * dt_s);
}

// Drops the sample before the newest if the pen jumped there and back.
void PenFilter::drop_stray() {
  const std::size_t n = held_.size();
  if (n < 3 || !is_jump(n - 3, n - 2) || !is_jump(n - 2, n - 1)) return;
  const Point before = held_[n - 3].position, stray = held_[n - 2].position;
  if (distance(before, held_[n - 1].position) > 0.5 * distance(before, stray)) return;
  held_.erase(held_.end() - 2);
  held_ms_.erase(held_ms_.end() - 2);
}

// Drops the first samples if they lie together and the pen jumped away from them: drivers report
// where the pen was lifted before. The stroke needs two samples after the jump to be a stroke.
void PenFilter::drop_stray_start() {
  for (std::size_t i = 1; i + 1 < held_.size(); ++i) {
    if (is_jump(i - 1, i)) {
      if (is_jump(i, i + 1)) return;
      drop_front(held_, i);
      drop_front(held_ms_, i);
      return;
    }
    if (distance(held_[0].position, held_[i].position) > kStrayStartMm) return;
  }
}

// Corrects late pressure and a blob at pen-down. `level_is_known` means that the stroke is longer
// than the window, so its newest pressure is the normal level.
void PenFilter::mend_start(bool level_is_known) {
  const auto first_real = std::find_if(held_.begin(), held_.end(),
                                       [](const InkSample& s) { return is_real(s.pressure); });
  if (first_real == held_.end()) return;
  for (auto s = held_.begin(); s != first_real; ++s) s->pressure = first_real->pressure;

  const std::optional<double> level = held_.back().pressure;
  if (!level_is_known || !is_real(level)) return;
  for (std::size_t i = 0; i < held_.size() && is_blob(i, 0, *level); ++i) held_[i].pressure = level;
}

// Returns true if sample i may belong to a blob at `end`, the first or last sample of the stroke.
// Callers stop at the first sample that does not belong to a blob, because pressure that rises
// first and then falls comes from the hand.
bool PenFilter::is_blob(std::size_t i, std::size_t end, double level) const noexcept {
  return held_[i].pressure.value_or(0.0) > options_.blob_ratio * level &&
         std::fabs(held_ms_[i] - held_ms_[end]) <= options_.blob_ms &&
         distance(held_[i].position, held_[end].position) <= options_.blob_mm;
}

void PenFilter::mend_end() {
  if (held_.size() >= 2 && is_jump(held_.size() - 2, held_.size() - 1)) held_.pop_back();
  if (held_.empty()) return;
  held_.resize(find_hook() + 1);

  const std::optional<double> level = held_.front().pressure;
  if (!is_real(level)) return;
  const std::size_t last = held_.size() - 1;
  for (std::size_t i = last; i > 0 && is_blob(i, last, *level); --i) held_[i].pressure = level;
}

// Returns the sharpest turn that starts a hook, or the last sample if there is no hook.
std::size_t PenFilter::find_hook() const noexcept {
  std::size_t best = held_.size() - 1;
  double best_deg = options_.hook_angle_deg;
  for (std::size_t turn = 0; turn + 1 < held_.size(); ++turn) {
    const double deg = turn_deg(turn);
    if (deg < best_deg || !is_hook(turn)) continue;
    best = turn;
    best_deg = deg;
  }
  return best;
}

bool PenFilter::is_hook(std::size_t turn) const noexcept {
  double before = 0.0, path_mm = 0.0;
  for (std::size_t i = 0; i <= turn; ++i)
    before = std::max(before, held_[i].pressure.value_or(0.0));
  for (std::size_t i = turn + 1; i < held_.size(); ++i) {
    path_mm += distance(held_[i - 1].position, held_[i].position);
    const auto pressure = held_[i].pressure;
    if (!pressure || *pressure > options_.hook_pressure_ratio * before) return false;
  }
  return path_mm <= options_.hook_max_mm &&
         distance(held_[turn].position, held_.back().position) >= options_.hook_min_mm;
}

// Returns the angle at sample `turn` between the path into it, over at least hook_min_mm, and the
// path out of it.
double PenFilter::turn_deg(std::size_t turn) const noexcept {
  const Point at = held_[turn].position;
  Point from = *last_released_;
  for (std::size_t i = turn; i-- > 0;) {
    if (distance(held_[i].position, at) < options_.hook_min_mm) continue;
    from = held_[i].position;
    break;
  }
  return angle_between(at - from, held_.back().position - at) * (180.0 / std::numbers::pi);
}

void PenFilter::release(std::size_t count) {
  if (count == 0) return;
  released_.insert(released_.end(), held_.begin(),
                   held_.begin() + static_cast<std::ptrdiff_t>(count));
  last_released_ = released_.back().position;
  drop_front(held_, count);
  drop_front(held_ms_, std::min(count, held_ms_.size()));
}

}  // namespace felt
