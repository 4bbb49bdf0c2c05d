#include <zip.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "felt/document/visible_strokes.h"
#include "felt/solid/solid_bytes.h"
#include "felt/solid/solid_writer.h"

namespace felt {
namespace threemf {

constexpr std::string_view kTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";
constexpr std::string_view kRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";

void append_attribute(std::string& out, const char* name, double value) {
  out.append(name).append("=\"");
  append_text(out, value);
  out += "\" ";
}

void append_mesh(std::string& out, const SolidBody& body) {
  out += "<mesh><vertices>\n";
  for (const Vec3& p : body.points) {
    out += "<vertex ";
    append_attribute(out, "x", p.x);
    append_attribute(out, "y", p.y);
    append_attribute(out, "z", p.z);
    out += "/>\n";
  }
  out += "</vertices><triangles>\n";
  constexpr std::array<const char*, 3> kNames = {"<triangle v1=\"", " v2=\"", " v3=\""};
  for (const SolidBody::Triangle& t : body.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      out += kNames[k];
      append_text(out, std::uint64_t{t[k]});
      out += '"';
    }
    out += "/>\n";
  }
  out += "</triangles></mesh>";
}

std::string model_of(const Solid& solid) {
  std::string colors, objects, items;
  for (std::size_t i = 0; i < solid.bodies.size(); ++i) {
    const SolidBody& body = solid.bodies[i];
    char color[16];
    std::snprintf(color, sizeof color, "#%02X%02X%02X", static_cast<unsigned>(body.color.r),
                  static_cast<unsigned>(body.color.g), static_cast<unsigned>(body.color.b));
    const std::string name = stroke_name(body.stroke), id = std::to_string(i + 2);
    colors += "<base name=\"" + name + "\" displaycolor=\"" + color + "\"/>";
    objects += "<object id=\"" + id + "\" name=\"" + name +
               "\" type=\"model\" pid=\"1\" pindex=\"" + std::to_string(i) + "\">";
    append_mesh(objects, body);
    objects += "</object>\n";
    items += "<item objectid=\"" + id + "\"/>";
  }
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Feltline</metadata>
<resources><basematerials id="1">)" +
         colors + "</basematerials>\n" + objects + "</resources><build>" + items +
         "</build>\n</model>\n";
}

struct Discard {
  void operator()(zip_t* zip) const noexcept { zip_discard(zip); }
};
struct Release {
  void operator()(zip_source_t* source) const noexcept { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, Release>;

/// Adds a file. Its time is the first that zip can hold, so that the same solid gives the same
/// bytes.
bool add_file(zip_t* zip, const char* name, std::string_view content) {
  constexpr zip_uint16_t kFirstDate = 1 << 5 | 1;  // 1 January 1980
  zip_source_t* source = zip_source_buffer(zip, content.data(), content.size(), 0);
  if (!source) return false;
  const zip_int64_t index = zip_file_add(zip, name, source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const auto at = static_cast<zip_uint64_t>(index);
  return zip_file_set_dostime(zip, at, 0, kFirstDate, 0) == 0;
}

/// Returns the content of a finished archive.
Result<std::string> content_of(zip_source_t* source) {
  zip_stat_t about;
  zip_stat_init(&about);
  std::string out;
  if (zip_source_stat(source, &about) == 0 && (about.valid & ZIP_STAT_SIZE) != 0 &&
      zip_source_open(source) == 0) {
    out.resize(about.size);
    const zip_int64_t read = zip_source_read(source, out.data(), out.size());
    zip_source_close(source);
    if (read == static_cast<zip_int64_t>(out.size()) && read > 0) return out;
  }
  return fail(ErrorCode::kIo, "the .3mf archive cannot be written");
}

}  // namespace threemf

Result<std::string> encode_3mf(const Solid& solid) {
  using namespace threemf;
  const std::string model = model_of(solid);
  zip_error_t error;
  zip_error_init(&error);
  const Source source(zip_source_buffer_create(nullptr, 0, 0, &error));
  std::unique_ptr<zip_t, Discard> zip(
      source ? zip_open_from_source(source.get(), ZIP_TRUNCATE, &error) : nullptr);
  zip_error_fini(&error);
  if (!zip) return fail(ErrorCode::kIo, "the .3mf archive cannot be started");
  zip_source_keep(source.get());  // closing the archive releases it once
  const bool added = add_file(zip.get(), "[Content_Types].xml", kTypes) &&
                     add_file(zip.get(), "_rels/.rels", kRelations) &&
                     add_file(zip.get(), "3D/3dmodel.model", model);
  if (!added || zip_close(zip.get()) != 0) {
    return fail(ErrorCode::kIo, "the .3mf archive cannot be written");
  }
  static_cast<void>(zip.release());
  return content_of(source.get());
}

}  // namespace felt
