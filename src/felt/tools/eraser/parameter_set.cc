#include "felt/tools/eraser/parameter_set.h"

#include <algorithm>

namespace felt {

bool ParameterSet::add(Interval interval) {
  if (!(interval.from < interval.to) || contains(interval)) return false;
  const auto first =
      std::lower_bound(intervals_.begin(), intervals_.end(), interval.from,
                       [](const Interval& i, double from) { return i.to < from - kGap; });
  auto last = first;
  for (; last != intervals_.end() && last->from <= interval.to + kGap; ++last) {
    interval.from = std::min(interval.from, last->from);
    interval.to = std::max(interval.to, last->to);
  }
  if (first == last) {
    intervals_.insert(first, interval);
  } else {
    *first = interval;
    intervals_.erase(first + 1, last);
  }
  return true;
}

bool ParameterSet::contains(Interval interval) const noexcept {
  const auto i = std::lower_bound(intervals_.begin(), intervals_.end(), interval.to,
                                  [](const Interval& a, double to) { return a.to < to; });
  return i != intervals_.end() && i->from <= interval.from;
}

}  // namespace felt
