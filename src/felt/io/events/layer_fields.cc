#include "felt/io/events/layer_fields.h"

#include <array>
#include <utility>

#include "felt/base/base64.h"
#include "felt/io/events/event_values.h"
#include "felt/render/picture_pixels.h"

namespace felt::json {
namespace {

/// Reads the number of a layer, a guide or another thing, which is at least 1.
Result<void> parse_id(Value& value, const std::string& key, const std::string& thing,
                      std::uint64_t& out) {
  const std::string_view token = token_of(value);
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(out) || out == 0) {
    return bad(key + ": " + excerpt(token) + " is not " + thing +
               ", which is a whole number, at least 1");
  }
  return {};
}

}  // namespace

Result<void> parse_layer(Value& value, EventFields& out) {
  return parse_id(value, "id", "a layer", out.layer.value);
}

Result<void> parse_guide_id(Value& value, EventFields& out) {
  return parse_id(value, "id", "a guide", out.layer.value);
}

Result<void> parse_body_id(Value& value, EventFields& out) {
  return parse_id(value, "id", "an edit of the body", out.layer.value);
}

Result<void> parse_timing_of(Value& value, EventFields& out) {
  return parse_id(value, "timing_of", "a layer", out.timing_of.value);
}

Result<void> parse_layer_number(Value& value, std::vector<LayerId>& out) {
  const std::string_view token = token_of(value);
  LayerId id;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(id.value) || !id) {
    return bad(excerpt(token) + " is not a layer, which is a whole number, at least 1");
  }
  if (out.size() == kMaxLayers) return bad("has more than 10000 layers");
  out.push_back(id);
  return {};
}

Result<void> parse_layers(Value& value, EventFields& out) {
  return for_each_element(value, "ids",
                          [&out](Value& item) { return parse_layer_number(item, out.layers); });
}

Result<void> parse_group(Value& value, EventFields& out) {
  const std::string_view token = token_of(value);
  GroupId group;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(group.value)) {
    return bad("group: " + excerpt(token) + " is not a group, which is a whole number");
  }
  out.group = group;
  return {};
}

Result<void> parse_index(Value& value, EventFields& out) {
  const std::string_view token = token_of(value);
  std::uint64_t index = 0;
  if (token.size() > limits::kMaxNumberChars || value.get_uint64().get(index)) {
    return bad("index: " + excerpt(token) +
               " is not an index, which is a whole number, at least 0");
  }
  out.index = index;
  return {};
}

Result<void> parse_matrix(Value& value, EventFields& out) {
  std::array<double, 6> m{};
  std::size_t count = 0;
  const auto add = [&](Value& item) -> Result<void> {
    const std::string_view token = token_of(item);
    if (count == m.size()) return bad("a matrix has only six numbers");
    if (read_number(item, kCoordinateLimit, m[count++])) return {};
    return tl::unexpected(number_error(token, kCoordinateLimit));
  };
  if (Result<void> read = for_each_element(value, "matrix", add); !read) return read;
  if (count < m.size()) return bad("matrix: has fewer than six numbers");
  out.matrix = Affine{m[0], m[1], m[2], m[3], m[4], m[5]};
  if (is_picture_place(*out.matrix)) return {};
  return bad("matrix: a picture cannot be placed like this");
}

Result<void> parse_mode(Value& value, EventFields& out) {
  BlendMode mode{};
  if (auto read = parse_word(value, "mode", kBlendModeNames, mode); !read) return read;
  out.mode = mode;
  return {};
}

Result<void> parse_png(Value& value, EventFields& out) {
  std::string text;
  constexpr std::size_t kMaxText = PictureData::kMaxBytes / 3 * 4 + 4;
  if (Result<void> read = parse_text(value, "png", text, kMaxText); !read) return read;
  std::optional<std::string> bytes = base64_bytes(text);
  if (!bytes) return bad("png: is not base64");
  auto data = make_picture_data(*std::move(bytes));
  if (!data) return tl::unexpected(with_context(data.error(), "png"));
  if (auto pixels = PicturePixels::decode(**data); !pixels) {
    return tl::unexpected(with_context(pixels.error(), "png"));
  }
  out.picture = *std::move(data);
  return {};
}

}  // namespace felt::json
