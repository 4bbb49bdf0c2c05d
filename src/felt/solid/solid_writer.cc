#include "felt/solid/solid_writer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "felt/base/ascii.h"
#include "felt/document/visible_strokes.h"
#include "felt/solid/solid_bytes.h"

namespace felt {
namespace solid_text {

constexpr std::size_t kHeaderBytes = 80;  // of an STL file

/// Returns the normal of a triangle; (0, 0, 0) if it has none, which readers then compute.
Vec3 facet_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a;
  const Vec3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = norm(n);
  return length > 0.0 ? (1.0 / length) * n : Vec3{};
}

void append_vertex(std::string& out, const Vec3& p) {
  out += "v ";
  append_text(out, p.x);
  out += ' ';
  append_text(out, p.y);
  out += ' ';
  append_text(out, p.z);
  out += '\n';
}

}  // namespace solid_text

std::optional<SolidFormat> solid_format_of(std::string_view name) noexcept {
  constexpr std::array<std::pair<std::string_view, SolidFormat>, 4> kFormats = {
      {{"stl", SolidFormat::kStl},
       {"obj", SolidFormat::kObj},
       {"3mf", SolidFormat::k3mf},
       {"glb", SolidFormat::kGlb}}};
  const auto same = [](char a, char b) { return ascii_lower(a) == b; };
  for (const auto& [text, format] : kFormats) {
    if (std::equal(name.begin(), name.end(), text.begin(), text.end(), same)) return format;
  }
  return std::nullopt;
}

Result<std::string> encode_solid(const Solid& solid, SolidFormat format, const FrontPaint* paint) {
  if (solid.bodies.empty()) return fail(ErrorCode::kInvalidArgument, "there is no body to write");
  switch (format) {
    case SolidFormat::kStl:
      return encode_stl(solid);
    case SolidFormat::kObj:
      return encode_obj(solid);
    case SolidFormat::k3mf:
      return encode_3mf(solid);
    case SolidFormat::kGlb:
      return encode_glb(solid, paint);
  }
  return fail(ErrorCode::kInvalidArgument, "unknown format of a solid");
}

bool loses_paint(const Solid& solid, SolidFormat format, const FrontPaint* paint) noexcept {
  if (format == SolidFormat::kGlb) return false;
  const auto is_painted = [](const SolidBody& body) { return !body.paint.empty(); };
  return paint != nullptr || std::any_of(solid.bodies.begin(), solid.bodies.end(), is_painted);
}

Result<std::string> encode_stl(const Solid& solid) {
  const std::size_t count = triangle_count(solid);
  if (count > std::numeric_limits<std::uint32_t>::max()) {
    return fail(ErrorCode::kLimitExceeded, "too many triangles for .stl");
  }
  // The header must not begin with "solid", because readers would expect the text variant.
  std::string out = "Feltline, binary STL, unit: mm";
  out.resize(solid_text::kHeaderBytes, ' ');
  append_raw(out, static_cast<std::uint32_t>(count));
  for (const SolidBody& body : solid.bodies) {
    for (const auto& [a, b, c] : body.triangles) {
      const Vec3 &p = body.points[a], &q = body.points[b], &r = body.points[c];
      append_floats(out, solid_text::facet_normal(p, q, r));
      for (const Vec3& corner : {p, q, r}) append_floats(out, corner);
      append_raw(out, std::uint16_t{0});
    }
  }
  return out;
}

Result<std::string> encode_obj(const Solid& solid) {
  std::string out = "# Feltline, unit: mm\n";
  std::uint64_t before = 1;  // OBJ numbers points from 1, over all groups
  for (std::size_t i = 0; i < solid.bodies.size(); ++i) {
    const SolidBody& body = solid.bodies[i];
    out += "o body" + std::to_string(i + 1) + "-" + stroke_name(body.stroke) + "\n";
    for (const Vec3& p : body.points) solid_text::append_vertex(out, p);
    for (const SolidBody::Triangle& t : body.triangles) {
      out += 'f';
      for (const std::uint32_t corner : t) {
        out += ' ';
        append_text(out, before + corner);
      }
      out += '\n';
    }
    before += body.points.size();
  }
  return out;
}

}  // namespace felt
