#include "felt/stroke/profile_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

bool is_before(const WidthKnot& k, double u) {
  return k.u < u;
}

/// Among the points strictly between `from` and `to`, finds the one whose width or tone is farthest
/// from the straight line between them. Returns its index, and the distance in tolerances.
std::pair<std::size_t, double> farthest(const std::vector<WidthKnot>& places, std::size_t from,
                                        std::size_t to, double tolerance_mm) {
  std::pair<std::size_t, double> worst{from, -1.0};
  for (std::size_t i = from + 1; i < to; ++i) {
    const WidthKnot line = knot_at(std::array{places[from], places[to]}, places[i].u);
    const double error = std::max(std::fabs(places[i].width_mm - line.width_mm) / tolerance_mm,
                                  std::fabs(places[i].tone - line.tone) / kFollowedTone);
    if (error > worst.second) worst = {i, error};
  }
  return worst;
}

}  // namespace

void ProfileBuilder::append(double v, const WidthKnot& ink) {
  if (knots_.empty() || v > knots_.back().u) knots_.push_back({v, ink.width_mm, ink.tone});
}

void ProfileBuilder::append_knots(double u0, double u1, double v0, double scale) {
  auto k = std::upper_bound(old_.begin(), old_.end(), u0,
                            [](double u, const WidthKnot& a) { return u < a.u; });
  for (; k != old_.end() && k->u < u1; ++k) append(v0 + (k->u - u0) * scale, *k);
}

void ProfileBuilder::shift(double u0, double u1, double by) {
  const auto k = std::lower_bound(old_.begin(), old_.end(), u0, is_before);
  const bool knot_here = k != old_.end() && k->u == u0;
  if (!was_shifted_ || knots_.empty() || knot_here) append(u0 + by, knot_at(old_, u0));
  append_knots(u0, u1, u0 + by, 1.0);
  was_shifted_ = true;
}

void ProfileBuilder::stretch(double u0, double u1, double v0, double v1) {
  append(v0, knot_at(old_, u0));
  append_knots(u0, u1, v0, (v1 - v0) / (u1 - u0));
  was_shifted_ = false;
}

void ProfileBuilder::follow(std::span<const Match> matches, double tolerance_mm) {
  // Collects width and tone at the matches and at the breakpoints between them, in the order of v.
  // The algorithm of Douglas and Peucker then selects those that are needed.
  std::vector<WidthKnot> places;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Match& m = matches[i];
    if (i > 0) {
      const Match& before = matches[i - 1];
      auto k = std::lower_bound(old_.begin(), old_.end(), before.u, is_before);
      for (; k != old_.end() && k->u < m.u; ++k) {
        if (k->u == before.u) continue;
        const double share = (k->u - before.u) / (m.u - before.u);
        places.push_back({before.v + share * (m.v - before.v), k->width_mm, k->tone});
      }
    }
    const WidthKnot here = knot_at(old_, m.u);
    places.push_back({m.v, here.width_mm, here.tone});
  }
  std::vector<std::size_t> kept{0, places.size() - 1};
  for (std::size_t i = 0; i + 1 < kept.size();) {
    const auto [worst, error] = farthest(places, kept[i], kept[i + 1], tolerance_mm);
    if (error > 1.0) {
      kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(i) + 1, worst);
    } else {
      ++i;
    }
  }
  kept.pop_back();  // the next part or finish() adds the end
  for (const std::size_t i : kept) append(places[i].u, places[i]);
  was_shifted_ = false;
}

std::vector<WidthKnot> ProfileBuilder::finish(double end) && {
  while (!knots_.empty() && knots_.back().u >= end) knots_.pop_back();
  knots_.push_back({end, old_.back().width_mm, old_.back().tone});
  return std::move(knots_);
}

}  // namespace felt
