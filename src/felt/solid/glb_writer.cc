#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "felt/document/visible_strokes.h"
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

/// The lists of a glTF document, and its binary buffer.
class GlbDocument {
 public:
  void add_body(const SolidBody& body);
  [[nodiscard]] std::string json() const;
  [[nodiscard]] const std::string& buffer() const noexcept { return buffer_; }

 private:
  std::string add_points(const std::vector<Vec3>& points, bool with_bounds);
  std::string add_indices(const SolidBody& body);
  std::string add_accessor(std::size_t offset, int target, const std::string& fields);

  std::string buffer_, views_, accessors_, meshes_, materials_, nodes_, children_;
  int bodies_ = 0, accessor_count_ = 0;
};

std::string GlbDocument::add_accessor(std::size_t offset, int target, const std::string& fields) {
  append_item(views_, R"({"buffer":0,"byteOffset":)" + std::to_string(offset) +
                          R"(,"byteLength":)" + std::to_string(buffer_.size() - offset) +
                          R"(,"target":)" + std::to_string(target) + "}");
  append_item(accessors_,
              R"({"bufferView":)" + std::to_string(accessor_count_) + "," + fields + "}");
  return std::to_string(accessor_count_++);
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

std::string GlbDocument::add_indices(const SolidBody& body) {
  const std::size_t offset = buffer_.size();
  for (const SolidBody::Triangle& t : body.triangles) {
    for (const std::uint32_t corner : t) append_raw(buffer_, corner);
  }
  return add_accessor(offset, kElementArrayBuffer,
                      R"("componentType":)" + std::to_string(kUnsignedInt) + R"(,"count":)" +
                          std::to_string(3 * body.triangles.size()) + R"(,"type":"SCALAR")");
}

void GlbDocument::add_body(const SolidBody& body) {
  const std::string positions = add_points(body.points, true);
  const std::string normals = add_points(point_normals(body), false);
  const std::string indices = add_indices(body);
  const std::string number = std::to_string(bodies_++);
  std::string color;
  for (const std::uint8_t part : {body.color.r, body.color.g, body.color.b}) {
    std::string text;
    append_text(text, linear(part));
    append_item(color, text);
  }
  append_item(materials_, R"({"pbrMetallicRoughness":{"baseColorFactor":[)" + color +
                              R"(,1],"metallicFactor":0,"roughnessFactor":0.6}})");
  append_item(meshes_, R"({"primitives":[{"attributes":{"POSITION":)" + positions +
                           R"(,"NORMAL":)" + normals + R"(},"indices":)" + indices +
                           R"(,"material":)" + number + "}]}");
  append_item(nodes_, R"({"name":")" + stroke_name(body.stroke) + R"(","mesh":)" + number + "}");
  append_item(children_, number);
}

std::string GlbDocument::json() const {
  // The unit of glTF is the metre, so the last node, which holds all bodies, scales mm.
  return R"({"asset":{"version":"2.0","generator":"Feltline"},"scene":0,"scenes":[{"nodes":[)" +
         std::to_string(bodies_) + R"(]}],"nodes":[)" + nodes_ + R"(,{"name":"mm","children":[)" +
         children_ + R"(],"scale":[0.001,0.001,0.001]}],"meshes":[)" + meshes_ +
         R"(],"materials":[)" + materials_ + R"(],"accessors":[)" + accessors_ +
         R"(],"bufferViews":[)" + views_ + R"(],"buffers":[{"byteLength":)" +
         std::to_string(buffer_.size()) + "}]}";
}

}  // namespace glb

Result<std::string> encode_glb(const Solid& solid) {
  glb::GlbDocument document;
  for (const SolidBody& body : solid.bodies) document.add_body(body);
  std::string json = document.json();
  json.resize((json.size() + 3) / 4 * 4, ' ');    // chunks are multiples of 4 bytes
  const std::string& buffer = document.buffer();  // 4-byte numbers only
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
