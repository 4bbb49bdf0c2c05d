#pragma once

/// Our own attributes in InkML, next to the traces, so that a drawing is read back exactly. Private
/// to this layer; docs/formats/inkml.md describes them.

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

/// Namespace of our attributes, and the version of their meaning.
inline constexpr std::string_view kFeltNamespace = "https://feltline.org/ns/inkml/1";
inline constexpr std::string_view kInkmlNamespace = "http://www.w3.org/2003/InkML";

/// Traces are rounded to this grid.
inline constexpr double kStepsPerMm = 1000.0;

/// Returns a checksum of the points and widths of a trace in steps of the grid, independent of how
/// they are written. If it differs from the one stored next to the exact curve, another program has
/// changed the trace.
std::uint64_t trace_sum(std::span<const WidePoint> trace) noexcept;

/// Appends the attributes of a stroke's exact model to its trace element. Fails if an id or medium
/// is longer than 4096 bytes or XML cannot hold it, or if a coordinate is beyond 1e9 mm.
Result<void> append_model(std::string& out, std::string_view id, const Stroke& stroke,
                          std::span<const WidePoint> trace);

/// Returns the stroke that the attributes of a trace describe, in `color`; nullopt if the trace has
/// no such attributes. Fails if they do not describe a stroke, or if they were written for a
/// different `trace`.
std::optional<Result<NamedStroke>> read_model(const pugi::xml_node& node, const std::string& prefix,
                                              std::span<const WidePoint> trace, Rgba color);

/// Appends the attributes of the root: the page, "297 210 #ffffffff", the surface, and any
/// materials. `paper` replaces the colour of the page. Fails if XML cannot hold a surface name or
/// text.
Result<void> append_sheet(std::string& out, const Drawing& drawing,
                          const std::optional<Rgba>& paper);
/// Reads these attributes. Returns false if the text of a material was skipped because it is not
/// valid.
bool read_sheet(const pugi::xml_node& root, const std::string& prefix, Drawing& drawing);

}  // namespace felt::inkml
