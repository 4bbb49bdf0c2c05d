#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "felt/document/visible_strokes.h"
#include "felt/io/picture/png.h"
#include "felt/render/view.h"
#include "felt/solid/creases.h"
#include "felt/solid/solid_bytes.h"
#include "felt/solid/solid_writer.h"

namespace felt {
namespace glb {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

/// Returns an 8-bit sRGB value as linear light, as glTF wants it (IEC 61966-2-1).
double linear(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// Joins items of a JSON list.
void append_item(std::string& list, const std::string& item) {
  if (!list.empty()) list += ',';
  list += item;
}

/// Which triangles of a body: those without paint (on any side, the front, or the back), or those
/// with paint at a corner.
enum class Side { kAll, kFront, kBack, kPainted };

bool is_on(const SolidBody& body, const SolidBody::Triangle& t, Side side) {
  const auto has_paint = [&body](std::uint32_t i) { return body.paint[i].a > 0; };
  const bool is_painted = !body.paint.empty() && std::any_of(t.begin(), t.end(), has_paint);
  if (is_painted || side == Side::kPainted) return is_painted && side == Side::kPainted;
  return side == Side::kAll || is_front(body, t) == (side == Side::kFront);
}

/// The lists of a glTF document, and its binary buffer.
class GlbDocument {
 public:
  /// Fails if there is too little memory for the picture of the front.
  Result<void> add_body(const SolidBody& body, const FrontPaint* paint);
  [[nodiscard]] std::string json() const;
  [[nodiscard]] const std::string& buffer() const noexcept { return buffer_; }

 private:
  std::string add_points(const std::vector<Vec3>& points, bool with_bounds);
  std::string add_indices(const SolidBody& body, Side side);
  std::string add_colors(const SolidBody& body);
  std::string add_picture_positions(const SolidBody& body, const FrontPaint& front);
  std::string add_material(const std::string& color);
  std::string add_textured_material(const std::string& png);
  std::string add_view(std::size_t offset, const std::string& more);
  std::string add_accessor(std::size_t offset, int target, const std::string& fields);

  std::string buffer_, views_, accessors_, meshes_, materials_, images_, textures_, nodes_,
      children_;
  int bodies_ = 0, view_count_ = 0, accessor_count_ = 0, material_count_ = 0, image_count_ = 0;
};

std::string GlbDocument::add_view(std::size_t offset, const std::string& more) {
  append_item(views_, R"({"buffer":0,"byteOffset":)" + std::to_string(offset) +
                          R"(,"byteLength":)" + std::to_string(buffer_.size() - offset) + more +
                          "}");
  return std::to_string(view_count_++);
}

std::string GlbDocument::add_accessor(std::size_t offset, int target, const std::string& fields) {
  const std::string view = add_view(offset, R"(,"target":)" + std::to_string(target));
  append_item(accessors_, R"({"bufferView":)" + view + "," + fields + "}");
  return std::to_string(accessor_count_++);
}

/// Where each point lies on the picture of the front, from 0 to 1.
std::string GlbDocument::add_picture_positions(const SolidBody& body, const FrontPaint& front) {
  const std::size_t offset = buffer_.size();
  for (const Vec3& p : body.points) {
    const Vec px = front.to_px(p);
    append_raw(buffer_, static_cast<float>(px.x / front.ink.width()));
    append_raw(buffer_, static_cast<float>(px.y / front.ink.height()));
  }
  return add_accessor(offset, kArrayBuffer,
                      R"("componentType":)" + std::to_string(kFloat) + R"(,"count":)" +
                          std::to_string(body.points.size()) + R"(,"type":"VEC2")");
}

std::string GlbDocument::add_material(const std::string& color) {
  append_item(materials_, R"({"pbrMetallicRoughness":{)" + color +
                              R"("metallicFactor":0,"roughnessFactor":0.6}})");
  return std::to_string(material_count_++);
}

std::string GlbDocument::add_textured_material(const std::string& png) {
  const std::size_t offset = buffer_.size();
  buffer_ += png;
  const std::string view = add_view(offset, "");
  buffer_.resize((buffer_.size() + 3) / 4 * 4);  // numbers begin at multiples of 4 bytes
  const std::string number = std::to_string(image_count_++);
  append_item(images_, R"({"bufferView":)" + view + R"(,"mimeType":"image/png"})");
  append_item(textures_, R"({"source":)" + number + R"(,"sampler":0})");
  return add_material(R"("baseColorTexture":{"index":)" + number + "},");
}

std::string GlbDocument::add_points(const std::vector<Vec3>& points, bool with_bounds) {
  const std::size_t offset = buffer_.size();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{kInfinity, kInfinity, kInfinity},
      high{-kInfinity, -kInfinity, -kInfinity};
  for (const Vec3& p : points) {
    append_floats(buffer_, p);
    const std::array<float, 3> stored = {static_cast<float>(p.x), static_cast<float>(p.y),
                                         static_cast<float>(p.z)};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], stored[k]);
      high[k] = std::max(high[k], stored[k]);
    }
  }
  std::string fields = R"("componentType":)" + std::to_string(kFloat) + R"(,"count":)" +
                       std::to_string(points.size()) + R"(,"type":"VEC3")";
  for (const bool is_low : {true, false}) {
    if (!with_bounds) break;  // only positions must have them
    std::string values;
    for (const float value : is_low ? low : high) {
      std::string text;
      append_text(text, static_cast<double>(value));
      append_item(values, text);
    }
    fields += (is_low ? R"(,"min":[)" : R"(,"max":[)") + values + "]";
  }
  return add_accessor(offset, kArrayBuffer, fields);
}

std::string GlbDocument::add_indices(const SolidBody& body, Side side) {
  const std::size_t offset = buffer_.size();
  std::size_t count = 0;
  for (const SolidBody::Triangle& t : body.triangles) {
    if (!is_on(body, t, side)) continue;
    for (const std::uint32_t corner : t) append_raw(buffer_, corner);
    count += 3;
  }
  return add_accessor(offset, kElementArrayBuffer,
                      R"("componentType":)" + std::to_string(kUnsignedInt) + R"(,"count":)" +
                          std::to_string(count) + R"(,"type":"SCALAR")");
}

/// The colour of each point, as linear light.
std::string GlbDocument::add_colors(const SolidBody& body) {
  std::vector<Vec3> colors;
  for (const Rgba c : point_colors(body)) {
    colors.push_back({linear(c.r), linear(c.g), linear(c.b)});
  }
  return add_points(colors, false);
}

Result<void> GlbDocument::add_body(const SolidBody& whole, const FrontPaint* paint) {
  const SolidBody body = split_at_creases(whole);
  const bool is_plain = paint == nullptr && body.paint.empty();
  const Rgba shown = is_plain ? body.color : shown_color(body.color);
  std::string color;
  for (const std::uint8_t part : {shown.r, shown.g, shown.b}) {
    std::string text;
    append_text(text, linear(part));
    append_item(color, text);
  }
  const std::string attributes = R"("POSITION":)" + add_points(body.points, true) +
                                 R"(,"NORMAL":)" + add_points(point_normals(body), false);
  const std::string plain = add_material(R"("baseColorFactor":[)" + color + ",1],");
  std::string primitives;
  const auto add_primitive = [&](const std::string& fields, Side side,
                                 const std::string& material) {
    append_item(primitives, R"({"attributes":{)" + fields + R"(},"indices":)" +
                                add_indices(body, side) + R"(,"material":)" + material + "}");
  };
  const Result<std::optional<FrontPaint>> front =
      paint == nullptr ? std::nullopt : painted_front(body, *paint);
  if (!front) return tl::unexpected(front.error());
  if (!body.paint.empty()) {
    add_primitive(attributes + R"(,"COLOR_0":)" + add_colors(body), Side::kPainted,
                  add_material(R"("baseColorFactor":[1,1,1,1],)"));
  }
  if (!*front) {
    add_primitive(attributes, Side::kAll, plain);
  } else {
    const FrontPaint& painted = **front;
    const Result<std::string> png = encode_png(painted.ink, painted.px_per_mm * kMmPerInch);
    if (!png) return tl::unexpected(png.error());
    const std::string textured = add_textured_material(*png);
    add_primitive(attributes + R"(,"TEXCOORD_0":)" + add_picture_positions(body, painted),
                  Side::kFront, textured);
    add_primitive(attributes, Side::kBack, plain);
  }
  const std::string number = std::to_string(bodies_++);
  append_item(meshes_, R"({"primitives":[)" + primitives + "]}");
  append_item(nodes_, R"({"name":")" + stroke_name(body.stroke) + R"(","mesh":)" + number + "}");
  append_item(children_, number);
  return {};
}

std::string GlbDocument::json() const {
  // The unit of glTF is the metre, so the last node, which holds all bodies, scales mm.
  return R"({"asset":{"version":"2.0","generator":"Feltline"},"scene":0,"scenes":[{"nodes":[)" +
         std::to_string(bodies_) + R"(]}],"nodes":[)" + nodes_ + R"(,{"name":"mm","children":[)" +
         children_ + R"(],"scale":[0.001,0.001,0.001]}],"meshes":[)" + meshes_ +
         R"(],"materials":[)" + materials_ + "]" +
         (images_.empty() ? ""
                          : R"(,"images":[)" + images_ + R"(],"textures":[)" + textures_ +
                                R"(],"samplers":[{"wrapS":33071,"wrapT":33071}])") +
         R"(,"accessors":[)" + accessors_ + R"(],"bufferViews":[)" + views_ +
         R"(],"buffers":[{"byteLength":)" + std::to_string(buffer_.size()) + "}]}";
}

}  // namespace glb

Result<std::string> encode_glb(const Solid& solid, const FrontPaint* paint) {
  glb::GlbDocument document;
  for (const SolidBody& body : solid.bodies) {
    if (auto done = document.add_body(body, paint); !done) return tl::unexpected(done.error());
  }
  std::string json = document.json();
  json.resize((json.size() + 3) / 4 * 4, ' ');    // chunks are multiples of 4 bytes
  const std::string& buffer = document.buffer();  // also a multiple of 4 bytes
  const std::size_t bytes = 12 + 8 + json.size() + 8 + buffer.size();
  if (bytes > std::numeric_limits<std::uint32_t>::max()) {
    return fail(ErrorCode::kLimitExceeded, "too many triangles for .glb");
  }
  std::string out;
  append_raw(out, glb::kMagic);
  append_raw(out, std::uint32_t{2});
  append_raw(out, static_cast<std::uint32_t>(bytes));
  append_raw(out, static_cast<std::uint32_t>(json.size()));
  append_raw(out, glb::kJsonChunk);
  out += json;
  append_raw(out, static_cast<std::uint32_t>(buffer.size()));
  append_raw(out, glb::kBinaryChunk);
  out += buffer;
  return out;
}

}  // namespace felt
