#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "felt/tools/offer.h"

namespace felt::bench {

/// Counts of gestures that simulated people meant.
struct MeantStrokes {
  OfferKind kind = OfferKind::kInk;
  std::size_t drawn = 0;
  std::size_t offered = 0;  ///< the meant gesture was among the offers
  std::size_t first = 0;    ///< it was the first one
};

/// Lets `people` persons of the simulated population make each gesture, in three sizes each. If
/// `each`, prints each one that is not found, with the features of a scratch-out.
std::vector<MeantStrokes> draw_meant(std::size_t people, std::uint64_t seed, bool each);

}  // namespace felt::bench
