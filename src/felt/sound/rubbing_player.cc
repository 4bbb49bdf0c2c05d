#include "felt/sound/rubbing_player.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kFarthestMm = 1e6;
constexpr double kMaxPushN = 20.0;
constexpr double kFastestStrike = 1000.0;

// One sample of sound lasts 62500/3 ns.
constexpr std::int64_t ns_of(std::int64_t samples) noexcept {
  return samples * 62500 / 3;
}

RubbingSample sane(RubbingSample sample) noexcept {
  const bool is_place =
      std::fabs(sample.at.x) <= kFarthestMm && std::fabs(sample.at.y) <= kFarthestMm;
  if (!is_place) sample.at = {};
  if (!is_place || !(sample.push_n > 0.0)) sample.push_n = 0.0;
  sample.push_n = std::min(sample.push_n, kMaxPushN);
  return sample;
}

double within(double value, double smallest, double largest) noexcept {
  return value > smallest ? std::min(value, largest) : smallest;
}

RubbingPair sane(RubbingPair pair) noexcept {
  pair.grain_um = within(pair.grain_um, 0.0, 1e4);
  pair.stiffness_n_per_m = within(pair.stiffness_n_per_m, 50.0, 5000.0);
  pair.friction = within(pair.friction, 0.0, 3.0);
  pair.firm_push_n = within(pair.firm_push_n, 0.05, kMaxPushN);
  for (double* share : {&pair.through, &pair.wear, &pair.loudness, &pair.surface_brightness,
                        &pair.medium_brightness, &pair.squeak}) {
    *share = within(*share, 0.0, 1.0);
  }
  return pair;
}

}  // namespace

void RubbingPlayer::set_pair(const RubbingPair& pair) noexcept {
  next_pair_ = sane(pair);
}

void RubbingPlayer::push(const RubbingSample& sample) noexcept {
  if (count_ > 0 && sample.time_ns <= waiting(count_ - 1).time_ns) return;
  RubbingSample next = sane(sample);
  // Touches are detected here and not during playback, because a path that continues after a pause
  // is not a new touch.
  const bool comes_down = next.push_n > 0.0 && !(count_ > 0 && waiting(count_ - 1).push_n > 0.0);
  const bool is_known = next.strike_mm_per_s > 0.0;
  next.strike_mm_per_s = !comes_down ? 0.0
                         : is_known  ? std::min(next.strike_mm_per_s, kFastestStrike)
                                     : RubbingSynth::kUsualStrike;
  if (count_ == kMaxWaiting) {
    first_ = (first_ + 1) % kMaxWaiting;
    --count_;
  }
  way_[(first_ + count_) % kMaxWaiting] = next;
  if (count_++ == 0 && !has_started_) start_at(sample.time_ns);
}

std::int64_t RubbingPlayer::now_ns() const noexcept {
  return start_ns_ + ns_of(played_);
}

void RubbingPlayer::start_at(std::int64_t time_ns) noexcept {
  has_started_ = true;
  start_ns_ = time_ns;
  played_ = 0;
}

std::size_t RubbingPlayer::ready() const noexcept {
  if (count_ == 0) return 0;
  const std::int64_t ahead_ns = waiting(count_ - 1).time_ns - start_ns_;
  const std::int64_t samples = ahead_ns / 62500 * 3 + ahead_ns % 62500 * 3 / 62500 + 1;
  return samples > played_ ? static_cast<std::size_t>(samples - played_) : 0;
}

void RubbingPlayer::keep_up(double behind_s) noexcept {
  if (count_ == 0) return;
  const std::int64_t newest_ns = waiting(count_ - 1).time_ns;
  const auto wanted_ns = static_cast<std::int64_t>(1e9 * std::clamp(behind_s, 0.0, kMaxBehindS));
  const std::int64_t behind_ns = newest_ns - now_ns();
  constexpr auto kMaxNs = static_cast<std::int64_t>(1e9 * kMaxBehindS);
  if (behind_ns <= 0) waits_ = true;
  if (waits_ && behind_ns >= wanted_ns) waits_ = false;
  const bool is_free = voice_.is_silent() && behind_ns > 2 * wanted_ns;
  if (is_free || behind_ns > kMaxNs) start_at(newest_ns - wanted_ns);
}

bool RubbingPlayer::find(std::int64_t now_ns) noexcept {
  while (count_ > 1 && waiting(1).time_ns <= now_ns) {
    first_ = (first_ + 1) % kMaxWaiting;
    --count_;
  }
  if (count_ == 0) return false;
  const RubbingSample& from = waiting(0);
  if (from.time_ns > now_ns) return false;
  if (count_ == 1) {
    at_ = from.at;
    push_n_ = from.push_n;
    return from.time_ns == now_ns;
  }
  const RubbingSample& to = waiting(1);
  const std::int64_t gap_ns = to.time_ns - from.time_ns;
  const double way_mm = norm(to.at - from.at);
  if (gap_ns > kLongestGapNs || way_mm > 1e-9 * kFastestMmPerS * static_cast<double>(gap_ns)) {
    return false;
  }
  const double part = static_cast<double>(now_ns - from.time_ns) / static_cast<double>(gap_ns);
  // The pen is in contact only if it is in contact at both ends.
  const bool is_down = from.push_n > 0.0 && to.push_n > 0.0;
  at_ = from.at + part * (to.at - from.at);
  push_n_ = is_down ? from.push_n + part * (to.push_n - from.push_n) : 0.0;
  if (from.strike_mm_per_s > 0.0 && from.time_ns != struck_ns_ && pair_ == next_pair_) {
    struck_ns_ = from.time_ns;
    voice_.strike(from.strike_mm_per_s);
  }
  return true;
}

float RubbingPlayer::next() noexcept {
  const bool has_way = !waits_ && find(now_ns());
  if (!waits_) ++played_;
  // A new pair of surface and medium starts when the old pair is silent. Until then the pen counts
  // as lifted.
  if (!(pair_ == next_pair_) && voice_.is_silent()) {
    pair_ = next_pair_;
    voice_.set_pair(pair_);
  }
  const bool is_down = has_way && push_n_ > 0.0 && pair_ == next_pair_;
  return static_cast<float>(voice_.next(at_, is_down ? push_n_ : 0.0));
}

void RubbingPlayer::render(std::span<float> out) noexcept {
  for (float& sample : out) sample = next();
}

}  // namespace felt
