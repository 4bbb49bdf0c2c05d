#include "felt/gather/strip_positions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "felt/gather/percentile.h"

namespace felt {
namespace {

constexpr double kStripStepShare = 1.0 / 100.0;  // of the strip's diagonal
constexpr double kStripReachShare = 0.25;        // of the strip's diagonal
constexpr double kGapShare = 0.25;               // of the diagonal: the widest gap within a strip
constexpr double kGapFactor = 4.0;               // a gap so much wider than usual ends the strip
constexpr double kOwnShare = 0.5;  // of the diagonal: a line beside itself has gone round

/// Two points beside each other: at `here` on one line and `there` on another, in mm.
struct Contact {
  double here = 0.0, there = 0.0;
};

/// All contacts of a line with another one.
struct Contacts {
  std::vector<Contact> at;
  int votes = 0;  // for the same direction minus for opposite directions
};

Rect box_of(std::span<const RoughLine> lines) {
  Rect box;
  for (const RoughLine& line : lines) {
    for (const Point p : line) box.extend(p);
  }
  return box;
}

using ContactTable = std::vector<std::map<std::uint32_t, Contacts>>;  // of each line

// In a large bundle the nearest lines connect those that are farther away.
std::size_t kept_hits(std::size_t lines) {
  constexpr std::size_t kMaxHits = 64, kMinHits = 4, kHitsOfAll = 64 * 100;
  return std::clamp(kHitsOfAll / std::max<std::size_t>(lines, 1), kMinHits, kMaxHits);
}

/// Finds the positions of all lines.
class StripSolver {
 public:
  explicit StripSolver(std::span<const RoughLine> lines)
      : box_(box_of(lines)),
        diagonal_mm_(std::hypot(box_.width(), box_.height())),
        grid_(lines, {.step_mm = kStripStepShare * diagonal_mm_,
                      .reach_mm = kStripReachShare * diagonal_mm_,
                      .max_hits = kept_hits(lines.size()),
                      .own_mm = kOwnShare * diagonal_mm_}),
        placed_(lines.size(), 0),
        sign_(lines.size(), 1.0),
        offset_(lines.size(), 0.0),
        contacts_(lines.size()),
        far_contacts_(lines.size()) {
    find_contacts();
    place_all();
  }

  StripPositions positions();

 private:
  void find_contacts();
  void place_all();
  bool place_beside(const ContactTable& table);
  bool place_at_end();
  void find_period(StripPositions& result) const;
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(placed_.size()); }
  [[nodiscard]] double position(std::uint32_t line, double along_mm) const {
    return offset_[line] + sign_[line] * along_mm;
  }

  Rect box_;
  double diagonal_mm_;
  LineGrid grid_;
  std::vector<char> placed_;
  std::vector<double> sign_, offset_;  // position = offset + sign * arc length
  ContactTable contacts_, far_contacts_;
};

// Walks outwards on each section. Lines beyond a gap that is much wider than usual are far
// contacts.
void StripSolver::find_contacts() {
  std::vector<double> nearest;
  for (std::uint32_t i = 0; i < count(); ++i) {
    grid_.sections(i, [&](const LineSection& section) {
      double gap = std::numeric_limits<double>::infinity();
      if (!section.above.empty()) gap = section.above.front().offset_mm;
      if (!section.below.empty()) gap = std::min(gap, -section.below.front().offset_mm);
      if (std::isfinite(gap)) nearest.push_back(gap);
    });
  }
  if (nearest.empty()) return;
  const double usual =
      std::min(kGapFactor * percentile(nearest, 0.5) + kStripStepShare * diagonal_mm_,
               kGapShare * diagonal_mm_);
  for (std::uint32_t i = 0; i < count(); ++i) {
    grid_.sections(i, [&](const LineSection& section) {
      for (const auto side : {section.below, section.above}) {
        double previous = 0.0, widest = 0.0;
        for (const SectionHit& hit : side) {
          widest = std::max(widest, std::fabs(hit.offset_mm) - previous);
          previous = std::fabs(hit.offset_mm);
          Contacts& contacts = (widest <= usual ? contacts_ : far_contacts_)[i][hit.line];
          contacts.at.push_back({section.along_mm, hit.along_mm});
          contacts.votes += hit.cosine > 0.0 ? 1 : -1;
        }
      }
    });
  }
}

// Places the line that has the most contacts with one placed line. Returns false if there is none.
bool StripSolver::place_beside(const ContactTable& table) {
  std::size_t most = 0;
  std::uint32_t from = 0, to = 0;
  for (std::uint32_t i = 0; i < count(); ++i) {
    if (!placed_[i]) continue;
    for (const auto& [other, contacts] : table[i]) {
      if (placed_[other] || contacts.at.size() <= most) continue;
      most = contacts.at.size();
      from = i;
      to = other;
    }
  }
  if (most == 0) return false;
  const Contacts& contacts = table[from].at(to);
  sign_[to] = contacts.votes < 0 ? -sign_[from] : sign_[from];
  std::vector<double> offsets;
  for (const Contact& c : contacts.at) {
    offsets.push_back(position(from, c.here) - sign_[to] * c.there);
  }
  offset_[to] = percentile(offsets, 0.5);
  placed_[to] = 1;
  return true;
}

// Places the line whose end is nearest to an end of a placed line, as its continuation.
bool StripSolver::place_at_end() {
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t from = 0, to = 0;
  bool from_last = false, to_last = false;
  for (std::uint32_t i = 0; i < count(); ++i) {
    if (!placed_[i]) continue;
    for (std::uint32_t k = 0; k < count(); ++k) {
      if (placed_[k] || grid_.points(k).empty()) continue;
      for (int ends = 0; ends < 4; ++ends) {
        const auto a = grid_.points(i), b = grid_.points(k);
        const bool a_last = (ends & 1) != 0, b_last = (ends & 2) != 0;
        const double gap = distance(a_last ? a.back() : a.front(), b_last ? b.back() : b.front());
        if (gap >= least) continue;
        least = gap;
        from = i;
        to = k;
        from_last = a_last;
        to_last = b_last;
      }
    }
  }
  if (!std::isfinite(least)) return false;
  // Positions grow from the end of one line to the other if they grow towards that end.
  sign_[to] = from_last == to_last ? -sign_[from] : sign_[from];
  const double outwards = from_last ? sign_[from] : -sign_[from];
  const double at = position(from, from_last ? grid_.length_mm(from) : 0.0) + outwards * least;
  offset_[to] = at - sign_[to] * (to_last ? grid_.length_mm(to) : 0.0);
  placed_[to] = 1;
  return true;
}

void StripSolver::place_all() {
  std::uint32_t longest = 0;
  for (std::uint32_t i = 1; i < count(); ++i) {
    if (grid_.length_mm(i) > grid_.length_mm(longest)) longest = i;
  }
  placed_[longest] = 1;
  while (place_beside(contacts_) || place_beside(far_contacts_) || place_at_end()) {
  }
}

// A strip is closed if most of the part that goes beyond one period lies beside its beginning.
void StripSolver::find_period(StripPositions& result) const {
  const double range = result.last_mm - result.first_mm;
  std::vector<double> periods;
  for (std::uint32_t i = 0; i < count(); ++i) {
    for (const auto& [other, contacts] : contacts_[i]) {
      for (const Contact& c : contacts.at) {
        const double difference = std::fabs(position(i, c.here) - position(other, c.there));
        if (difference > 0.4 * range) periods.push_back(difference);
      }
    }
  }
  if (periods.size() < 4) return;
  const auto contacts = static_cast<double>(periods.size());
  const double period = percentile(periods, 0.5);
  if (contacts * result.step_mm > 0.5 * (range - period)) result.period_mm = period;
}

StripPositions StripSolver::positions() {
  StripPositions result;
  result.step_mm = kStripStepShare * diagonal_mm_;
  result.first_mm = std::numeric_limits<double>::infinity();
  result.last_mm = -result.first_mm;
  for (std::uint32_t i = 0; i < count(); ++i) {
    const auto points = grid_.points(i);
    if (points.empty()) continue;
    const double length = grid_.length_mm(i);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double along = length * static_cast<double>(k) / static_cast<double>(points.size() - 1);
      result.points.push_back({i, points[k], position(i, along)});
      result.first_mm = std::min(result.first_mm, result.points.back().along_mm);
      result.last_mm = std::max(result.last_mm, result.points.back().along_mm);
    }
  }
  find_period(result);
  return result;
}

}  // namespace

StripPositions strip_positions(std::span<const RoughLine> lines) {
  return StripSolver(lines).positions();
}

}  // namespace felt
