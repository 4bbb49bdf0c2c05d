#include "felt/io/events/body_fields.h"

#include <array>
#include <utility>

#include "felt/io/events/event_values.h"
#include "felt/stroke/color_text.h"

namespace felt::json {
namespace {

/// Reads [x,y,z].
Result<Vec3> parse_vec3(Value& value, const char* what) {
  std::array<double, 3> xyz{};
  std::size_t count = 0;
  const auto add = [&](Value& item) -> Result<void> {
    const std::string_view token = token_of(item);
    if (count == xyz.size()) return bad(std::string(what) + " has only three numbers");
    if (read_number(item, kCoordinateLimit, xyz[count++])) return {};
    return tl::unexpected(number_error(token, kCoordinateLimit));
  };
  if (Result<void> read = for_each_element(value, what, add); !read) {
    return tl::unexpected(read.error());
  }
  if (count < xyz.size()) return bad(std::string(what) + " has three numbers");
  return Vec3{xyz[0], xyz[1], xyz[2]};
}

Result<void> parse_vec3s(Value& value, const char* key, std::vector<Vec3>& out) {
  return for_each_element(value, key, [&out](Value& item) -> Result<void> {
    if (out.size() == BodyEdit::kMaxPoints) return bad("has more than 20000 points");
    const Result<Vec3> point = parse_vec3(item, "a point");
    if (!point) return tl::unexpected(point.error());
    out.push_back(*point);
    return {};
  });
}

}  // namespace

Result<void> parse_body_kind(Value& value, EventFields& out) {
  out.has_kind = true;
  return parse_word(value, "kind", kBodyEditKindNames, out.body.edit.kind);
}

Result<void> parse_body_path(Value& value, EventFields& out) {
  return parse_vec3s(value, "path", out.body.edit.path_mm);
}

Result<void> parse_body_profile(Value& value, EventFields& out) {
  return parse_vec3s(value, "profile", out.body.edit.profile_mm);
}

Result<void> parse_body_view(Value& value, EventFields& out) {
  const Result<Vec3> view = parse_vec3(value, "view");
  if (!view) return tl::unexpected(view.error());
  out.body.edit.view = *view;
  return {};
}

Result<void> parse_body_color(Value& value, EventFields& out) {
  std::string text;
  if (Result<void> read = parse_text(value, "color", text); !read) return read;
  const auto color = color_from_text(text);
  if (!color) return bad("color: \"" + excerpt(text) + "\" is not a colour such as #b02020");
  out.body.edit.color = *color;
  return {};
}

Result<BodyEvent> body_event(EventFields&& fields) {
  using Do = BodyEvent::Do;
  BodyEvent event{fields.body.what};
  if (event.what == Do::kRemove) {
    if (!fields.layer) return bad("key \"id\" is missing");
    event.id = {fields.layer.value};
  }
  if (event.what != Do::kAdd) return event;
  if (!fields.has_kind) return bad("key \"kind\" is missing");
  event.edit = std::move(fields.body.edit);
  if (Result<void> fine = check_body_edit(event.edit); !fine) return tl::unexpected(fine.error());
  return event;
}

}  // namespace felt::json
