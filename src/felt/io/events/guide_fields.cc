#include "felt/io/events/guide_fields.h"

#include <array>

namespace felt::json {
namespace {

/// Adds a point [x,y] of a guide.
Result<void> parse_guide_point(Value& value, std::vector<Point>& out) {
  if (out.size() == kMaxGuidePoints) return bad("a guide has at most 20000 points");
  std::array<double, 2> xy{};
  std::size_t count = 0;
  const auto add = [&](Value& item) -> Result<void> {
    const std::string_view token = token_of(item);
    if (count == xy.size()) return bad("a point has only two numbers");
    if (read_number(item, kCoordinateLimit, xy[count++])) return {};
    return tl::unexpected(number_error(token, kCoordinateLimit));
  };
  if (Result<void> read = for_each_element(value, "point", add); !read) return read;
  if (count < xy.size()) return bad("a point has two numbers");
  out.push_back({xy[0], xy[1]});
  return {};
}

}  // namespace

Result<void> parse_guide_points(Value& value, EventFields& out) {
  return for_each_element(
      value, "points", [&out](Value& item) { return parse_guide_point(item, out.guide.points); });
}

Result<void> parse_guide_times(Value& value, EventFields& out) {
  return for_each_element(value, "times_ms", [&out](Value& item) -> Result<void> {
    const std::string_view token = token_of(item);
    double ms = 0.0;
    if (out.guide.times_ms.size() == kMaxGuidePoints) {
      return bad("a guide has at most 20000 times");
    }
    if (!read_number(item, kEventTimeLimit, ms)) {
      return tl::unexpected(number_error(token, kEventTimeLimit));
    }
    out.guide.times_ms.push_back(ms);
    return {};
  });
}

Result<void> parse_closed_guide(Value& value, EventFields& out) {
  const Result<bool> closed = read_bool(value);
  if (!closed) return tl::unexpected(with_context(closed.error(), "closed"));
  out.guide.is_closed = *closed;
  return {};
}

}  // namespace felt::json
