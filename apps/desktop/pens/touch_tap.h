#pragma once

#include <QPointF>
#include <QTouchEvent>
#include <cstdint>
#include <map>
#include <optional>

namespace felt::desktop {

/// Recognises a tap with several fingers: all fingers go down and up within kMaxNs, and none moves
/// farther than kMaxMovePx. Two fingers that pinch or turn the view move farther or stay longer.
class TouchTap {
 public:
  /// The limits of a tap: of the same order as those of other systems (Android's double tap time is
  /// 300 ms, its touch slop 8 dp), with a margin because several fingers never land together.
  static constexpr std::int64_t kMaxNs = 350'000'000;
  static constexpr double kMaxMovePx = 16.0;

  /// Handles a touch event that happened at this time. Returns the number of fingers if it ends a
  /// tap.
  std::optional<int> take(const QTouchEvent& event, std::int64_t time_ns);
  /// Ignores this touch until all fingers are lifted: it does not count as a tap.
  void cancel() noexcept { is_tap_ = false; }

 private:
  bool is_tap_ = false;
  std::int64_t start_ns_ = 0;
  std::map<int, QPointF> fingers_;  // where each finger went down
};

}  // namespace felt::desktop
