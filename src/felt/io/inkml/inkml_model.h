#pragma once

/// Feltline's attributes of traces and of the root element in InkML. They let a drawing be read
/// back exactly. Private to this layer; docs/formats/inkml.md describes them.

#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>

#include "felt/document/drawing.h"
#include "felt/io/ink_of_points.h"
#include "felt/stroke/named_stroke.h"
#include "felt/stroke/stroke.h"

namespace felt::inkml {

/// Namespace of our attributes, and the version of their format.
inline constexpr std::string_view kFeltNamespace = "https://feltline.org/ns/inkml/1";
inline constexpr std::string_view kInkmlNamespace = "http://www.w3.org/2003/InkML";

/// Traces are rounded to this grid.
inline constexpr double kStepsPerMm = 1000.0;

/// Returns a checksum of the points and widths of a trace, rounded to steps of the grid. It does
/// not depend on how the numbers are written. If it differs from the checksum that is stored with
/// the exact curve, another program has changed the trace.
std::uint64_t trace_sum(std::span<const WidePoint> trace) noexcept;

/// Appends the attributes of a stroke's exact model to its trace element. `number` is
/// stroke_name(), or empty if a reader gets the id from `id`. Fails if a name or the medium is
/// longer than 4096 bytes or has characters that XML cannot hold, or if a coordinate is beyond 1e9
/// mm.
Result<void> append_model(std::string& out, std::string_view id, std::string_view number,
                          const Stroke& stroke, std::span<const WidePoint> trace);

/// Returns the stroke that our attributes of a trace element describe, with the colour `color`, or
/// nullopt if the element has no such attributes. Fails if the attributes do not describe a valid
/// stroke, or if they belong to points other than those in `trace`.
std::optional<Result<NamedStroke>> read_model(const pugi::xml_node& node, const std::string& prefix,
                                              std::span<const WidePoint> trace, Rgba color);

/// Appends our attributes of the root element: the page, for example "297 210 #ffffffff", the
/// surface, and the materials, if there are any. `paper` replaces the colour of the page. Fails if
/// XML cannot hold a surface name or text.
Result<void> append_page(std::string& out, const Drawing& drawing,
                         const std::optional<Rgba>& paper);
/// Reads the attributes that append_page() writes. Returns false if the text of a material was
/// skipped because it is not valid.
bool read_page(const pugi::xml_node& root, const std::string& prefix, Drawing& drawing);

}  // namespace felt::inkml
