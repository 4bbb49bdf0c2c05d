// The queries of SegmentBvh. A nearest query walks the tree depth first and visits the nearest
// child box first. It skips every box that is farther than the best segment found so far.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "felt/geometry/bvh.h"
#include "felt/geometry/bvh_box.h"

namespace felt {
namespace {

// Four floats in one SSE2 or NEON register, and the result of comparing them (-1 is true). Uses the
// vector extensions of GCC and Clang, because neither compiler vectorises the plain loop, and GCC
// splits wider comparisons if the target has no AVX.
using Floats [[gnu::vector_size(16)]] = float;
using Flags [[gnu::vector_size(16)]] = std::int32_t;

// Returns half h, 0 or 1, of a row of eight.
inline Floats half_of(const std::array<float, 8>& row, unsigned h) noexcept {
  Floats half;
  std::memcpy(&half, &row[4 * h], sizeof half);
  return half;
}

// Returns a mask in which bit i is set if lane i is true.
inline unsigned bits_of(const Flags& flags) noexcept {
  const Flags bits = flags & Flags{1, 2, 4, 8};
  std::array<std::uint64_t, 2> words{};
  std::memcpy(words.data(), &bits, sizeof words);
  const std::uint64_t all = words[0] | words[1];
  return static_cast<unsigned>((all | (all >> 32U)) & 15U);
}

}  // namespace

// The position of a node in the tree.
struct SegmentBvh::NodeAt {
  // Maximum number of nodes that can wait during a depth-first search.
  static constexpr unsigned kStack = (kFanOut - 1) * kMaxLevels + kFanOut;

  unsigned level;       // 0: children are segments
  std::uint32_t index;  // within the level
};

const SegmentBvh::Node& SegmentBvh::node(NodeAt at) const noexcept {
  return nodes_[level_begin_[at.level] + at.index];
}

// One nearest query; all its memory is on the stack.
class SegmentBvh::NearestSearch {
 public:
  // Does not clear waiting_, because it is written before it is read.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  NearestSearch(const SegmentBvh& tree, const Query& query) noexcept
      : tree_(tree),
        query_(query),
        // The smallest box of floats that contains the point.
        x0_(float_below(query.point.x)),
        y0_(float_below(query.point.y)),
        x1_(float_above(query.point.x)),
        y1_(float_above(query.point.y)),
        pieces_left_(query.cap.pieces) {
    limit_to(query.radius_mm * query.radius_mm);
  }

  Hit run() noexcept {
    const Point p = query_.point;
    if (tree_.levels_ == 0 || !is_finite(p) || !(query_.radius_mm >= 0.0)) return hit_;
    if (query_.seed < tree_.size() && pieces_left_ > 0) try_slot(tree_.slots_[query_.seed]);
    seed_slot_ = hit_ ? tree_.slots_[query_.seed] : kNone;
    push({0.0F, {tree_.levels_ - 1, 0}});
    while (count_ > 0) {
      const Waiting next = waiting_[--count_];
      if (next.distance_squared > limit_float_) continue;
      if (hit_.used.nodes >= query_.cap.nodes || pieces_left_ <= 0) {
        hit_.proven = false;
        break;
      }
      ++hit_.used.nodes;
      visit(next.at);
    }
    if (pieces_left_ <= 0) hit_.proven = false;
    hit_.used.pieces = query_.cap.pieces - pieces_left_;
    return hit_;
  }

 private:
  struct Waiting {
    float distance_squared;
    NodeAt at;
  };
  struct Child {
    float distance_squared;
    unsigned index;
  };

  void push(const Waiting& w) noexcept { waiting_[count_++] = w; }

  // Rounds the limit up for comparisons in floats: the box distance below has a relative error of
  // at most 4 x 2^-24, the factor allows 16 times that, and the least normal float covers
  // underflow.
  void limit_to(double distance_squared) noexcept {
    limit_ = distance_squared;
    limit_float_ = static_cast<float>(std::min(distance_squared * (1.0 + 0x1p-18), 1e38)) +
                   std::numeric_limits<float>::min();
  }

  // Stores the children within the limit in `near`, nearest first, and returns their number.
  unsigned near_children(const Node& n, std::array<Child, kFanOut>& near) const noexcept {
    std::array<float, kFanOut> d{};
    unsigned mask = 0;
    for (unsigned h = 0; h < 2; ++h) {
      const Floats zero{};
      const Floats left = half_of(n.x0, h) - x1_, right = x0_ - half_of(n.x1, h);
      const Floats above = half_of(n.y0, h) - y1_, below = y0_ - half_of(n.y1, h);
      Floats dx = left > right ? left : right, dy = above > below ? above : below;
      dx = dx > zero ? dx : zero;
      dy = dy > zero ? dy : zero;
      const Floats squared = dx * dx + dy * dy;  // infinity if the child is absent
      mask |= bits_of(squared <= limit_float_) << (4 * h);
      std::memcpy(&d[4 * h], &squared, sizeof squared);
    }
    unsigned count = 0;
    for (; mask != 0; mask &= mask - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(mask));
      unsigned place = count++;
      for (; place > 0 && near[place - 1].distance_squared > d[i]; --place) {
        near[place] = near[place - 1];
      }
      near[place] = {d[i], i};
    }
    return count;
  }

  void visit(NodeAt at) noexcept {
    std::array<Child, kFanOut> near{};
    const unsigned count = near_children(tree_.node(at), near);
    if (at.level > 0) {
      for (unsigned k = count; k-- > 0;) {
        push({near[k].distance_squared, {at.level - 1, at.index * kFanOut + near[k].index}});
      }
      return;
    }
    for (unsigned k = 0; k < count && near[k].distance_squared <= limit_float_; ++k) {
      const std::uint32_t slot = at.index * kFanOut + near[k].index;
      if (pieces_left_ <= 0) return;
      if (slot != seed_slot_) try_slot(slot);
    }
  }

  [[nodiscard]] bool comes_first(std::uint32_t a, std::uint32_t b) const noexcept {
    const auto order = tree_.refs_[a] <=> tree_.refs_[b];
    return order != 0 ? order < 0 : a < b;
  }

  void try_slot(std::uint32_t slot) noexcept {
    const std::optional<Nearest> found =
        nearest_within(tree_.curves_[slot], query_.point, limit_, pieces_left_);
    if (!found) return;
    const std::uint32_t handle = tree_.handles_[slot];
    const double best = hit_ ? hit_.nearest.distance_squared : limit_;
    const double d = found->distance_squared;
    if (d > best || (d == best && hit_ && !comes_first(handle, hit_.handle))) return;
    hit_.handle = handle;
    hit_.ref = tree_.refs_[handle];
    hit_.nearest = *found;
    limit_to(d);
  }

  const SegmentBvh& tree_;
  const Query& query_;
  float x0_, y0_, x1_, y1_;
  double limit_ = 0.0;
  float limit_float_ = 0.0F;
  int pieces_left_;
  std::uint32_t seed_slot_ = kNone;
  Hit hit_;
  unsigned count_ = 0;
  std::array<Waiting, NodeAt::kStack> waiting_;
};

SegmentBvh::Hit SegmentBvh::nearest(const Query& query) const noexcept {
  return NearestSearch(*this, query).run();
}

// Returns a mask in which bit i is set if child i intersects the box.
unsigned SegmentBvh::children_in(const Box& box, const Node& n) noexcept {
  unsigned mask = 0;
  for (unsigned h = 0; h < 2; ++h) {
    mask |= bits_of((half_of(n.x0, h) <= box.x1) & (half_of(n.x1, h) >= box.x0) &
                    (half_of(n.y0, h) <= box.y1) & (half_of(n.y1, h) >= box.y0))
            << (4 * h);
  }
  return mask;
}

void SegmentBvh::walk(const Rect& area, void (*visit)(void*, std::uint32_t), void* argument) const {
  if (levels_ == 0 || area.empty()) return;
  const Box box(area);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled before it is read
  std::array<NodeAt, NodeAt::kStack> waiting;
  unsigned count = 0;
  waiting[count++] = {levels_ - 1, 0};
  while (count > 0) {
    const NodeAt at = waiting[--count];
    for (unsigned mask = children_in(box, node(at)); mask != 0; mask &= mask - 1) {
      const std::uint32_t child =
          at.index * kFanOut + static_cast<unsigned>(std::countr_zero(mask));
      if (at.level == 0)
        visit(argument, handles_[child]);
      else
        waiting[count++] = {at.level - 1, child};
    }
  }
}

}  // namespace felt
