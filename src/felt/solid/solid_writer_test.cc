#include "felt/solid/solid_writer.h"

#include <gtest/gtest.h>
#include <zip.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <string>

#include "felt/solid/inflate.h"
#include "felt/solid/testing/solid_drawings.h"
#include "felt/solid/testing/surface.h"

namespace felt::solid_writer_test {
namespace {

using testing::examine;
using testing::Surface;
using testing::surface_of;
using testing::welded;

/// Two bodies: a ring, and a disc beside it; with colours.
Solid two_bodies() {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 30.0);
  drawing.circle({50, 50}, 12.0);
  drawing.circle({120, 50}, 20.0);
  Result<InflatedDrawing> result = inflate(drawing.document, {.triangles = 2000});
  EXPECT_TRUE(result) << result.error().message;
  result->solid.bodies[0].color = {255, 128, 0, 255};
  return std::move(result->solid);
}

std::string encoded(const Solid& solid, SolidFormat format) {
  const Result<std::string> bytes = encode_solid(solid, format);
  EXPECT_TRUE(bytes) << bytes.error().message;
  return bytes.value_or("");
}

template <class T>
T number_at(const std::string& bytes, std::size_t offset) {
  T value{};
  EXPECT_LE(offset + sizeof value, bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

Surface::Corner corner_at(const std::string& bytes, std::size_t offset) {
  return {number_at<float>(bytes, offset), number_at<float>(bytes, offset + 4),
          number_at<float>(bytes, offset + 8)};
}

/// Checks a surface that was read back: the ring and the disc, closed.
void expect_both(const Surface& surface, const Solid& solid) {
  const testing::SurfaceReport report = examine(surface);
  EXPECT_EQ(report.fault, "");
  EXPECT_EQ(report.components, 2U);
  EXPECT_EQ(report.euler, 2);  // 0 for the ring, 2 for the disc
  double volume = 0.0;
  for (const SolidBody& body : solid.bodies) volume += volume_mm3(body);
  EXPECT_NEAR(report.volume_mm3, volume, 1e-4 * volume);
  EXPECT_EQ(surface.triangles.size(), triangle_count(solid));
}

TEST(SolidWriter, StlReadsBackAsAClosedSurface) {
  const Solid solid = two_bodies();
  const std::string bytes = encoded(solid, SolidFormat::kStl);
  ASSERT_NE(bytes.substr(0, 5), "solid");
  const auto count = number_at<std::uint32_t>(bytes, 80);
  ASSERT_EQ(bytes.size(), 84 + 50 * std::size_t{count});
  Surface surface;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = 84 + 50 * i;
    const auto normal = corner_at(bytes, at);
    float squared = 0.0F;
    for (const float part : normal) squared += part * part;
    EXPECT_NEAR(static_cast<double>(squared), 1.0, 1e-5);
    const std::size_t first = surface.points.size();
    for (std::size_t k = 1; k <= 3; ++k) surface.points.push_back(corner_at(bytes, at + 12 * k));
    surface.triangles.push_back({first, first + 1, first + 2});
    EXPECT_EQ(number_at<std::uint16_t>(bytes, at + 48), 0);
  }
  expect_both(welded(surface), solid);
}

TEST(SolidWriter, ObjReadsBackAsAClosedSurface) {
  const Solid solid = two_bodies();
  std::istringstream lines(encoded(solid, SolidFormat::kObj));
  Surface surface;
  std::size_t objects = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "o") ++objects;
    if (kind == "v") {
      Surface::Corner p{};
      words >> p[0] >> p[1] >> p[2];
      surface.points.push_back(p);
    } else if (kind == "f") {
      std::array<std::size_t, 3> t{};
      for (std::size_t& corner : t) {
        words >> corner;
        ASSERT_GE(corner, 1U);
        ASSERT_LE(corner, surface.points.size());
        --corner;
      }
      surface.triangles.push_back(t);
    }
    ASSERT_TRUE(words || kind == "o" || kind == "#") << line;
  }
  EXPECT_EQ(objects, 2U);
  expect_both(surface, solid);
}

TEST(SolidWriter, GlbHasItsChunksAndTheBoundsOfItsAccessors) {
  const Solid solid = two_bodies();
  const std::string bytes = encoded(solid, SolidFormat::kGlb);
  ASSERT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 4), 2U);
  ASSERT_EQ(number_at<std::uint32_t>(bytes, 8), bytes.size());
  const std::size_t json_size = number_at<std::uint32_t>(bytes, 12);
  ASSERT_EQ(bytes.substr(16, 4), "JSON");
  const std::size_t data = 20 + json_size + 8;
  ASSERT_EQ(bytes.substr(data - 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(json_size % 4, 0U);
  EXPECT_EQ(data + number_at<std::uint32_t>(bytes, data - 8), bytes.size());

  const auto json = nlohmann::json::parse(bytes.substr(20, json_size));
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_EQ(json["buffers"][0]["byteLength"], bytes.size() - data);
  const auto place_of = [&](const nlohmann::json& accessor) {
    const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t offset = view["byteOffset"];
    const bool is_vector = accessor["type"] == "VEC3";
    EXPECT_EQ(view["byteLength"], accessor["count"].get<std::size_t>() * (is_vector ? 12 : 4));
    EXPECT_LE(offset + view["byteLength"].get<std::size_t>(), bytes.size() - data);
    EXPECT_EQ(view["target"], is_vector ? 34962 : 34963);
    EXPECT_EQ(accessor["componentType"], is_vector ? 5126 : 5125);
    return data + offset;
  };
  ASSERT_EQ(json["meshes"].size(), 2U);
  Surface surface;
  for (const auto& mesh : json["meshes"]) {
    const auto& primitive = mesh["primitives"][0];
    const auto accessor = [&](const nlohmann::json& number) {
      return json["accessors"][number.get<std::size_t>()];
    };
    const auto positions = accessor(primitive["attributes"]["POSITION"]);
    const auto normals = accessor(primitive["attributes"]["NORMAL"]);
    const auto indices = accessor(primitive["indices"]);
    EXPECT_EQ(positions["count"], normals["count"]);
    std::array<float, 3> low{1e30F, 1e30F, 1e30F}, high{-1e30F, -1e30F, -1e30F};
    const std::size_t first = surface.points.size();
    for (std::size_t i = 0; i < positions["count"]; ++i) {
      surface.points.push_back(corner_at(bytes, place_of(positions) + 12 * i));
      const auto n = corner_at(bytes, place_of(normals) + 12 * i);
      const double length = std::sqrt(static_cast<double>(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
      ASSERT_NEAR(length, 1.0, 1e-5);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], surface.points.back()[k]);
        high[k] = std::max(high[k], surface.points.back()[k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(positions["min"][k].get<float>(), low[k]);
      EXPECT_EQ(positions["max"][k].get<float>(), high[k]);
    }
    for (std::size_t i = 0; i + 2 < indices["count"]; i += 3) {
      std::array<std::size_t, 3> t{};
      for (std::size_t k = 0; k < 3; ++k) {
        t[k] = first + number_at<std::uint32_t>(bytes, place_of(indices) + 4 * (i + k));
        ASSERT_LT(t[k], surface.points.size());
      }
      surface.triangles.push_back(t);
    }
    const auto& color = json["materials"][primitive["material"].get<std::size_t>()]
                            ["pbrMetallicRoughness"]["baseColorFactor"];
    EXPECT_EQ(color.size(), 4U);
  }
  const auto& color = json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_NEAR(color[0].get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(color[1].get<double>(), 0.2158605, 1e-6);  // 128 in linear light
  expect_both(surface, solid);
}

/// Returns a file of a zip archive, or an empty text.
std::string file_in(const std::string& bytes, const char* name) {
  zip_error_t error;
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* zip = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
  EXPECT_NE(zip, nullptr);
  if (zip == nullptr) return "";
  std::string content;
  EXPECT_EQ(zip_get_num_entries(zip, 0), 3);
  if (zip_file_t* file = zip_fopen(zip, name, 0)) {
    std::array<char, 4096> part{};
    for (zip_int64_t n = 0; (n = zip_fread(file, part.data(), part.size())) > 0;) {
      content.append(part.data(), static_cast<std::size_t>(n));
    }
    zip_fclose(file);
  }
  zip_discard(zip);
  return content;
}

TEST(SolidWriter, ThreemfIsAnArchiveOfThreePartsWithBothBodies) {
  const Solid solid = two_bodies();
  const std::string bytes = encoded(solid, SolidFormat::k3mf);
  EXPECT_NE(file_in(bytes, "[Content_Types].xml").find("3dmanufacturing-3dmodel+xml"),
            std::string::npos);
  EXPECT_NE(file_in(bytes, "_rels/.rels").find("Target=\"/3D/3dmodel.model\""), std::string::npos);
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_string(file_in(bytes, "3D/3dmodel.model").c_str()));
  const pugi::xml_node model = xml.child("model");
  EXPECT_STREQ(model.attribute("unit").value(), "millimeter");
  EXPECT_STREQ(model.child("resources")
                   .child("basematerials")
                   .child("base")
                   .attribute("displaycolor")
                   .value(),
               "#FF8000");
  Surface surface;
  std::size_t objects = 0;
  for (const pugi::xml_node object : model.child("resources").children("object")) {
    ++objects;
    const std::size_t first = surface.points.size();
    for (const pugi::xml_node v : object.child("mesh").child("vertices").children("vertex")) {
      surface.points.push_back(
          {v.attribute("x").as_float(), v.attribute("y").as_float(), v.attribute("z").as_float()});
    }
    for (const pugi::xml_node t : object.child("mesh").child("triangles").children("triangle")) {
      surface.triangles.push_back({first + t.attribute("v1").as_uint(),
                                   first + t.attribute("v2").as_uint(),
                                   first + t.attribute("v3").as_uint()});
    }
    const auto build = model.child("build");
    EXPECT_TRUE(build.find_child_by_attribute("objectid", object.attribute("id").value()));
  }
  EXPECT_EQ(objects, 2U);
  expect_both(surface, solid);
}

TEST(SolidWriter, TheSameSolidGivesTheSameBytes) {
  for (const SolidFormat format :
       {SolidFormat::kStl, SolidFormat::kObj, SolidFormat::k3mf, SolidFormat::kGlb}) {
    EXPECT_EQ(encoded(two_bodies(), format), encoded(two_bodies(), format));
  }
}

TEST(SolidWriter, SaysWhichFormatsLoseThePaint) {
  Solid solid = two_bodies();
  const FrontPaint ink{Image::create(1, 1).value(), {}, 1.0};
  for (const SolidFormat format : {SolidFormat::kStl, SolidFormat::kObj, SolidFormat::k3mf}) {
    EXPECT_FALSE(loses_paint(solid, format, nullptr));
    EXPECT_TRUE(loses_paint(solid, format, &ink));
  }
  solid.bodies[1].paint.assign(solid.bodies[1].points.size(), Rgba{});
  EXPECT_TRUE(loses_paint(solid, SolidFormat::kStl, nullptr));
  EXPECT_FALSE(loses_paint(solid, SolidFormat::kGlb, &ink));
}

TEST(SolidWriter, NamesOfFormatsAndErrors) {
  EXPECT_EQ(solid_format_of("STL"), SolidFormat::kStl);
  EXPECT_EQ(solid_format_of("3mf"), SolidFormat::k3mf);
  EXPECT_EQ(solid_format_of("glb"), SolidFormat::kGlb);
  EXPECT_FALSE(solid_format_of("stlx"));
  EXPECT_FALSE(solid_format_of(""));
  EXPECT_FALSE(encode_solid({}, SolidFormat::kStl));
}

TEST(SolidCheck, FindsWhatIsNotClosed) {
  const SolidBody sound = two_bodies().bodies[0];
  EXPECT_TRUE(check_body(sound, {}));
  SolidBody open = sound;
  open.triangles.pop_back();
  EXPECT_FALSE(check_body(open, {}));
  SolidBody turned = sound;
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  EXPECT_FALSE(check_body(turned, {}));
  SolidBody flat = sound;
  flat.points[0] = flat.points[1];
  EXPECT_FALSE(check_body(flat, {}));
  SolidBody nowhere = sound;
  nowhere.points[3].z = 1e300;  // too large for a float
  EXPECT_FALSE(check_body(nowhere, {}));
  EXPECT_FALSE(check_body({}, {}));
}

}  // namespace
}  // namespace felt::solid_writer_test
