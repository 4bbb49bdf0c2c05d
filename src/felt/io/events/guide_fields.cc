#include "felt/io/events/guide_fields.h"

#include <array>
#include <utility>

namespace felt::json {
namespace {

/// Adds a point [x,y].
Result<void> parse_point(Value& value, std::vector<Point>& out) {
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
  return for_each_element(value, "points", [&out](Value& item) -> Result<void> {
    if (out.guide.points.size() == kMaxGuidePoints) {
      return bad("a guide has at most 20000 points");
    }
    return parse_point(item, out.guide.points);
  });
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

Result<void> parse_guide_kind(Value& value, EventFields& out) {
  const Result<std::string> text = read_name(value);
  if (!text) return tl::unexpected(with_context(text.error(), "kind"));
  std::string known;
  for (std::size_t i = 0; i < kDrawingGuideKinds; ++i) {
    const auto kind = static_cast<DrawingGuideKind>(i);
    if (guide_kind_name(kind) == *text) {
      out.guides.guide.kind = kind;
      out.has_kind = true;
      return {};
    }
    known += (known.empty() ? "" : ", ") + std::string(guide_kind_name(kind));
  }
  return bad("kind: \"" + excerpt(*text) + "\" is not one of " + known);
}

Result<void> parse_guide_axes(Value& value, EventFields& out) {
  const std::string_view token = token_of(value);
  std::uint64_t axes = 0;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(axes) || axes == 0 ||
      axes > DrawingGuide::kMaxAxes) {
    return bad("axes: " + excerpt(token) + " is not a whole number from 1 to 16");
  }
  out.guides.guide.axes = static_cast<int>(axes);
  return {};
}

Result<void> parse_guide_stroke(Value& value, EventFields& out) {
  const std::string_view token = token_of(value);
  StrokeId& stroke = out.guides.guide.stroke;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(stroke.value) || !stroke) {
    return bad("stroke: " + excerpt(token) + " is not a stroke, which is a whole number");
  }
  return {};
}

Result<GuidesEvent> guides_event(EventFields&& fields) {
  using Do = GuidesEvent::Do;
  GuidesEvent event{fields.guides.what};
  if (event.what == Do::kChange || event.what == Do::kRemove) {
    if (!fields.layer) return bad("key \"id\" is missing");
    event.id = {fields.layer.value};
  }
  if (event.what != Do::kAdd && event.what != Do::kChange) return event;
  if (!fields.has_kind) return bad("key \"kind\" is missing");
  event.guide = std::move(fields.guides.guide);
  event.guide.origin = {fields.position.x, fields.position.y};
  event.guide.points = std::move(fields.guide.points);
  event.guide.times_ms = std::move(fields.guide.times_ms);
  if (Result<void> fine = check_drawing_guide(event.guide); !fine) {
    return tl::unexpected(fine.error());
  }
  return event;
}

Result<void> parse_closed_guide(Value& value, EventFields& out) {
  const Result<bool> closed = read_bool(value);
  if (!closed) return tl::unexpected(with_context(closed.error(), "closed"));
  out.guide.is_closed = *closed;
  return {};
}

Result<void> parse_edges_page(Value& value, EventFields& out) {
  std::array<double, 4> page{};
  std::size_t count = 0;
  const auto add = [&](Value& item) -> Result<void> {
    const std::string_view token = token_of(item);
    if (count == page.size()) return bad("a page has only four numbers");
    if (read_number(item, kCoordinateLimit, page[count++])) return {};
    return tl::unexpected(number_error(token, kCoordinateLimit));
  };
  if (Result<void> read = for_each_element(value, "page", add); !read) return read;
  if (count < page.size()) return bad("page: has fewer than four numbers");
  out.edges.page = {page[0], page[1], page[2], page[3]};
  return out.edges.page.empty() ? bad("page: is not a rectangle") : Result<void>();
}

Result<void> parse_edges_selection(Value& value, EventFields& out) {
  const Result<bool> is_felt = read_bool(value);
  if (!is_felt) return tl::unexpected(with_context(is_felt.error(), "selection"));
  out.edges.selection = *is_felt;
  return {};
}

Result<void> parse_edges_contours(Value& value, EventFields& out) {
  std::size_t points = 0;
  const auto add = [&](Value& item) -> Result<void> {
    if (out.edges.contours.size() == UseEdges::kMaxContours) {
      return bad("there are at most 1000 contours");
    }
    std::vector<Point>& contour = out.edges.contours.emplace_back();
    return for_each_element(item, "contour", [&](Value& point) -> Result<void> {
      if (++points > UseEdges::kMaxContourPoints) return bad("contours have at most 20000 points");
      return parse_point(point, contour);
    });
  };
  return for_each_element(value, "contours", add);
}

}  // namespace felt::json
