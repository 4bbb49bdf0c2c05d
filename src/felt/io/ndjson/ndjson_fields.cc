#include "felt/io/ndjson/ndjson_fields.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "felt/geometry/tilt.h"
#include "felt/stroke/color_text.h"

namespace felt::json {
namespace {

/// The four elements of a point.
enum PointPart : std::size_t { kXPart, kYPart, kPressurePart, kTimePart, kPartCount };
constexpr std::array<const char*, kPartCount> kPartNames = {"x", "y", "pressure", "time"};

void set_part(std::size_t part, double number, InkSample& out) {
  if (part == kXPart) out.position.x = number;
  if (part == kYPart) out.position.y = number;
  if (part == kPressurePart) out.pressure = number;
  if (part == kTimePart) out.time_ns = std::llround(number * 1e6);
}

Result<void> parse_tilt(Value& value, InkSample& out) {
  const std::string_view token = token_of(value);
  if (token == "null") return {};
  double tilt_deg = 0.0;
  if (!read_number(value, kCoordinateLimit, tilt_deg)) {
    return tl::unexpected(with_context(number_error(token, kCoordinateLimit), "tilt"));
  }
  if (tilt_deg < 0.0 || tilt_deg > kMaxTiltDeg) {
    return bad("tilt: " + excerpt(token) + " is not an angle from 0 to 90 degrees");
  }
  out.tilt_deg = tilt_deg;
  return {};
}

/// Reads [x, y] in degrees. Any other list is ignored, like every unknown value.
Result<void> parse_tilt_xy(Value& value, std::optional<double>& tilt_deg) {
  simdjson::ondemand::json_type type{};
  simdjson::ondemand::array elements;
  if (const auto error = value.get_array().get(elements))
    return tl::unexpected(syntax_error(error));
  std::array<double, 2> angles{};
  std::size_t count = 0;
  bool is_pair = true;
  for (auto element : elements) {
    Value item;
    if (const auto error = element.get(item)) return tl::unexpected(syntax_error(error));
    if (const auto error = item.type().get(type)) return tl::unexpected(syntax_error(error));
    if (type != simdjson::ondemand::json_type::number || count == angles.size()) {
      is_pair = false;
      if (Result<void> fine = check_ignored(item); !fine) return fine;
      continue;
    }
    const std::string_view token = token_of(item);
    if (!read_number(item, kCoordinateLimit, angles[count++])) {
      return tl::unexpected(with_context(number_error(token, kCoordinateLimit), "tilt"));
    }
  }
  if (is_pair && count == angles.size()) tilt_deg = tilt_of_xy(angles[0], angles[1]);
  return {};
}

/// Reads a tilt as one angle from the upright, or as a pair of angles, which is used only if the
/// single angle is missing.
Result<void> parse_any_tilt(Value& value, InkSample& out, std::optional<double>& xy_tilt_deg) {
  simdjson::ondemand::json_type type{};
  if (const auto error = value.type().get(type)) return tl::unexpected(syntax_error(error));
  if (type == simdjson::ondemand::json_type::array) return parse_tilt_xy(value, xy_tilt_deg);
  if (type == simdjson::ondemand::json_type::object) return check_ignored(value);
  return parse_tilt(value, out);
}

/// Reads the element after the first four: the tilt of the pen, if the element is an object that
/// contains it.
Result<void> parse_more(Value& value, InkSample& out) {
  simdjson::ondemand::json_type type{};
  if (const auto error = value.type().get(type)) return tl::unexpected(syntax_error(error));
  if (type != simdjson::ondemand::json_type::object) return check_ignored(value);
  simdjson::ondemand::object members;
  if (const auto error = value.get_object().get(members))
    return tl::unexpected(syntax_error(error));
  std::optional<double> xy_tilt_deg;
  for (auto field : members) {
    simdjson::ondemand::field member;
    if (const auto error = std::move(field).get(member)) return tl::unexpected(syntax_error(error));
    std::string_view key;
    if (const auto error = member.unescaped_key().get(key))
      return tl::unexpected(syntax_error(error));
    Value item = member.value();
    // "tilt" is what older files call a single angle.
    Result<void> read = key == "tilt"   ? parse_any_tilt(item, out, xy_tilt_deg)
                        : key == "lean" ? parse_tilt(item, out)
                                        : check_ignored(item);
    if (!read) return read;
  }
  if (!out.tilt_deg) out.tilt_deg = xy_tilt_deg;
  return {};
}

Result<void> parse_part(Value& value, std::size_t part, InkSample& out) {
  if (part == kPartCount) return parse_more(value, out);
  if (part > kPartCount) return check_ignored(value);
  const std::string_view token = token_of(value);
  if (part >= kPressurePart && token == "null") return {};
  const NumberLimit limit = part == kTimePart ? kTimeLimit : kCoordinateLimit;
  double number = 0.0;
  if (!read_number(value, limit, number)) {
    return tl::unexpected(with_context(number_error(token, limit), kPartNames[part]));
  }
  set_part(part, number, out);
  return {};
}

Result<void> parse_point(Value& value, InkSample& out) {
  simdjson::ondemand::array parts;
  const std::string_view whole = token_of(value);
  if (value.get_array().get(parts)) return bad(excerpt(whole) + " is not an array");
  std::size_t count = 0;
  for (auto element : parts) {
    Value part;
    if (const auto error = element.get(part)) return tl::unexpected(syntax_error(error));
    if (Result<void> parsed = parse_part(part, count, out); !parsed) return parsed;
    ++count;
  }
  if (count < 2) return bad("a point needs x and y");
  return {};
}

Result<void> parse_segment(Value& value, std::vector<Point>& points) {
  std::array<double, 8> c{};
  if (Result<void> parsed = read_numbers(value, c); !parsed) return parsed;
  const Point start{c[0], c[1]};
  if (points.empty()) points.push_back(start);
  if (!(points.back() == start)) return bad("does not start at the end of the previous one");
  for (std::size_t k = 2; k < c.size(); k += 2) points.push_back({c[k], c[k + 1]});
  return {};
}

Result<void> parse_joint(Value& value, std::vector<JointKind>& joints) {
  const std::string_view token = token_of(value);
  std::string_view name;
  if (value.get_string().get(name) || (name != "smooth" && name != "corner")) {
    return bad(excerpt(token) + " is not \"smooth\" or \"corner\"");
  }
  joints.push_back(name == "smooth" ? JointKind::kSmooth : JointKind::kCorner);
  return {};
}

Result<void> parse_name(Value& value, const char* key, std::string& out) {
  Result<std::string> name = read_name(value);
  if (!name) return tl::unexpected(with_context(name.error(), key));
  out = std::move(*name);
  return {};
}

}  // namespace

Result<void> parse_id(Value& value, std::string& out) {
  const std::string_view token = token_of(value);
  const bool quoted = !token.empty() && token[0] == '"';
  double number = 0.0;
  if (quoted) return parse_name(value, "id", out);
  if (token.size() > limits::kMaxNumberChars || value.get_double().get(number)) {
    return bad("id: " + excerpt(token) + " is neither a string nor a number");
  }
  out = token;
  return {};
}

Result<void> parse_points(Value& value, std::vector<InkSample>& out) {
  Result<void> parsed = for_each_element(
      value, "points", [&out](Value& item) { return parse_point(item, out.emplace_back()); });
  if (parsed && out.empty()) return bad("points: is empty");
  return parsed;
}

Result<void> parse_closed(Value& value, bool& out) {
  const Result<bool> closed = read_bool(value);
  if (!closed) return tl::unexpected(with_context(closed.error(), "closed"));
  out = *closed;
  return {};
}

Result<void> parse_segments(Value& value, std::vector<Point>& out) {
  Result<void> parsed =
      for_each_element(value, "segments", [&out](Value& item) { return parse_segment(item, out); });
  if (parsed && out.empty()) return bad("segments: is empty");
  return parsed;
}

Result<void> parse_joints(Value& value, std::vector<JointKind>& out) {
  return for_each_element(value, "joints", [&out](Value& item) { return parse_joint(item, out); });
}

Result<void> parse_widths(Value& value, std::vector<WidthKnot>& out) {
  return for_each_element(value, "widths", [&out](Value& item) -> Result<void> {
    std::array<double, 2> knot{};
    if (Result<void> parsed = read_numbers(item, knot); !parsed) return parsed;
    out.push_back({knot[0], knot[1]});
    return {};
  });
}

Result<void> parse_tones(Value& value, std::vector<double>& out) {
  return for_each_element(value, "tones", [&out](Value& item) -> Result<void> {
    const std::string_view token = token_of(item);
    double tone = 0.0;
    if (!read_number(item, kSketchLimit, tone)) {
      return tl::unexpected(number_error(token, kSketchLimit));
    }
    if (!(tone >= 0.0 && tone <= 1.0)) return bad(excerpt(token) + " is not from 0 to 1");
    out.push_back(tone);
    return {};
  });
}

Result<void> parse_material(Value& value, std::string& out) {
  return parse_name(value, "material", out);
}

Result<void> parse_color(Value& value, Rgba& out) {
  std::string text;
  if (Result<void> parsed = parse_name(value, "color", text); !parsed) return parsed;
  const std::optional<Rgba> color = color_from_text(text);
  if (!color) return bad("color: " + excerpt(text) + " is not #rrggbb or #rrggbbaa");
  out = *color;
  return {};
}

Result<void> parse_version(Value& value) {
  const std::string_view token = token_of(value);
  std::int64_t version = 0;
  if (value.get_int64().get(version)) {
    return bad("feltline: " + excerpt(token) + " is not a format version");
  }
  if (version == 1) return {};
  return fail(ErrorCode::kUnsupported,
              "feltline: format version " + std::to_string(version) + " is not supported");
}

Result<void> parse_unit(Value& value) {
  std::string unit;
  if (Result<void> parsed = parse_name(value, "unit", unit); !parsed) return parsed;
  if (unit == "mm") return {};
  return fail(ErrorCode::kUnsupported, "unit: " + excerpt(unit) + " is not mm");
}

}  // namespace felt::json
