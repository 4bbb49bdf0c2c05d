#pragma once

#include <array>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/edit.h"

namespace felt::bench {

/// One pull: a position on a stroke, and the displacement of the pen from there.
struct Pull {
  StrokePtr stroke;
  double u = 0.0;
  Vec way;  ///< mm
};

/// The methods that are compared.
enum class Method {
  kBrush,    ///< the committed result of BrushPull, the pull of our tool
  kSoft,     ///< the committed result of GrabPull with `soft` weights
  kPaper,    ///< GrabPull with weights that blend the paper's cases
  kPrinted,  ///< eq. 7 as printed in the paper, tick by tick along the path
  kCases,    ///< the three cases as printed in the paper, with a hard switch, tick by tick
  kPoint,    ///< moves only the control point nearest to the grab
};
inline constexpr std::array kMethods = {Method::kBrush,   Method::kSoft,  Method::kPaper,
                                        Method::kPrinted, Method::kCases, Method::kPoint};

std::string_view name_of(Method method) noexcept;

/// Returns the data of the pulled stroke, which may not be G1. Fails if the method cannot make the
/// pull.
Result<StrokeData> pulled(Method method, const Pull& pull, double brush_radius_mm);

}  // namespace felt::bench
