#include "desktop/feel/force_history.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace felt::desktop {

void ForceHistory::clear() noexcept {
  for (auto& track : bins_) track.fill(kNothing);
  names_.fill("");
  names_[kAsked] = "asked";
  names_[kSent] = "sent";
  now_.fill(0.0F);
  tracks_ = 2;
  newest_ = -1;
}

void ForceHistory::add(const TickReport& tick) noexcept {
  const std::int64_t bin = std::max<std::int64_t>(tick.sample.time_ns, 0) / kBinNs;
  if (bin < newest_) clear();
  go_to(bin);
  std::array<Force, kTracks> sums{};
  for (const ForceTerms::Term& term : tick.terms) {
    const std::size_t track = track_of(term.name);
    if (track < kTracks) sums[track] += term.force;  // a term may occur several times in a tick
  }
  put(kAsked, norm(tick.asked));
  put(kSent, norm(tick.sent));
  for (std::size_t track = 2; track < tracks_; ++track) {
    put(track, tick.strength * norm(sums[track]));
  }
}

void ForceHistory::go_to(std::int64_t bin) noexcept {
  if (bin == newest_) return;
  const std::int64_t passed = std::min<std::int64_t>(bin - newest_, kBins);
  for (std::int64_t i = 0; i < passed; ++i) {
    for (auto& track : bins_) track[static_cast<std::size_t>(bin - i) % kBins] = kNothing;
  }
  newest_ = bin;
}

std::size_t ForceHistory::track_of(const char* name) noexcept {
  for (std::size_t track = 2; track < tracks_; ++track) {
    if (names_[track] == name || std::strcmp(names_[track], name) == 0) return track;
  }
  if (tracks_ == kTracks) return kTracks;
  names_[tracks_] = name;
  return tracks_++;
}

void ForceHistory::put(std::size_t track, double newton) noexcept {
  const float value = std::isfinite(newton) ? static_cast<float>(newton) : 0.0F;
  now_[track] = value;
  float& bin = bins_[track][static_cast<std::size_t>(newest_) % kBins];
  bin = std::max(bin, value);
}

float ForceHistory::at(std::size_t track, std::int64_t bin) const noexcept {
  const bool is_kept = bin >= 0 && bin <= newest_ && newest_ - bin < std::int64_t{kBins};
  return is_kept ? bins_[track][static_cast<std::size_t>(bin) % kBins] : kNothing;
}

float ForceHistory::largest(std::size_t track) const noexcept {
  return std::max(0.0F, *std::max_element(bins_[track].begin(), bins_[track].end()));
}

}  // namespace felt::desktop
