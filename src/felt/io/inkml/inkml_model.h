#pragma once

/// What our own InkML says beside the traces, so that a drawing comes back exactly. Private to this
/// layer; docs/formats/inkml.md describes it.

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

/// Namespace of our attributes, and the version of what they mean.
inline constexpr std::string_view kFeltNamespace = "https://feltline.org/ns/inkml/1";
inline constexpr std::string_view kInkmlNamespace = "http://www.w3.org/2003/InkML";

/// Traces are written on this grid.
inline constexpr double kStepsPerMm = 1000.0;

/// Fingerprint of the points and widths of a trace in steps of the grid, however they are written:
/// when it is another than the one beside the exact curve, another program has changed the trace.
std::uint64_t trace_sum(std::span<const WidePoint> trace) noexcept;

/// Appends the attributes of a stroke's exact model to its trace element. Error: an id or material
/// that XML cannot hold or of more than 4096 bytes, a coordinate beyond 1e9 mm.
Result<void> append_model(std::string& out, std::string_view id, const Stroke& stroke,
                          std::span<const WidePoint> trace);

/// The stroke that the attributes of a trace describe, in `color`. Nothing where there are none.
/// Error: they do not describe one, or `trace` is not the one they were written for.
std::optional<Result<NamedStroke>> read_model(const pugi::xml_node& node, const std::string& prefix,
                                              std::span<const WidePoint> trace, Rgba color);

/// Appends the attributes of the root: the page, "297 210 #ffffffff", the surface, and the
/// materials, as far as there are any. `paper` replaces the colour of the page. Error: a surface or
/// text that XML cannot hold.
Result<void> append_sheet(std::string& out, const Drawing& drawing,
                          const std::optional<Rgba>& paper);
/// Reads them. Returns false if a text of a material was left out because it is none.
bool read_sheet(const pugi::xml_node& root, const std::string& prefix, Drawing& drawing);

}  // namespace felt::inkml
