#include "felt/tools/pencil/wet_ink.h"

#include <algorithm>
#include <cmath>

namespace felt {

void WetInk::begin(const WidthMapOptions& widths) {
  pieces_.clear();
  segments_ = 0;
  places_ = samples_ = 0;
  stable_widths_ = WidthMap(widths);
  pen_widths_ = WidthMap(widths);
}

void WetInk::update(const InkFitter& fitter, const InkSample& sample) {
  pen_width_mm_ = pen_widths_.push(sample);
  while (segments_ < fitter.segment_count()) add_segment(fitter, segments_++);
}

void WetInk::add_segment(const InkFitter& fitter, int i) {
  const Cubic segment = fitter.segment(i);
  const double pieces = std::clamp(std::ceil(control_length(segment) / kPieceMm), 1.0, 64.0);
  double t0 = 0.0, width0 = stable_width_mm_;
  const auto add_piece = [&](double t1) {
    pieces_.push_back({sub_segment(segment, t0, t1), width0, stable_width_mm_});
    t0 = t1;
    width0 = stable_width_mm_;
  };
  const auto& places = fitter.places();
  const auto& samples = fitter.samples();
  for (; places_ < places.size() && places[places_].u <= i + 1; ++places_) {
    for (std::uint32_t k = 0; k < places[places_].count && samples_ < samples.size(); ++k) {
      const bool first = samples_ == 0;
      stable_width_mm_ = stable_widths_.push(samples[samples_++]);
      if (first) width0 = stable_width_mm_;
    }
    const double t = places[places_].u - i;
    if (t < 1.0 && (t - t0) * pieces >= 1.0) add_piece(t);
  }
  add_piece(1.0);
}

void WetInk::draw(InkFitter& fitter, Overlay& overlay) const {
  overlay.ink.insert(overlay.ink.end(), pieces_.begin(), pieces_.end());
  const auto tail = fitter.live_tail();
  const double from = pieces_.empty() ? pen_width_mm_ : stable_width_mm_;
  for (std::size_t k = 0; k < tail.size(); ++k) {
    const auto at = [&](std::size_t j) {
      const double share = static_cast<double>(j) / static_cast<double>(tail.size());
      return from + share * (pen_width_mm_ - from);
    };
    overlay.ink.push_back({tail[k], at(k), at(k + 1)});
  }
}

}  // namespace felt
