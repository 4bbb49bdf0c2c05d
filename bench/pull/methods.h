#pragma once

#include <array>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/edit.h"

namespace felt::bench {

/// One pull: a place on a stroke, and how far the pen goes from there.
struct Pull {
  StrokePtr stroke;
  double u = 0.0;
  Vec way;  ///< mm
};

/// What is compared.
enum class Method {
  kBrush,    ///< ours: BrushPull, what is committed
  kSoft,     ///< GrabPull with `soft` weights, what is committed
  kPaper,    ///< GrabPull with the paper's cases blended
  kPrinted,  ///< the paper, eq. 7 as printed, tick by tick along the way
  kCases,    ///< the paper, its three cases as printed with a hard switch, tick by tick
  kPoint,    ///< the control point nearest to the grab is dragged along, and nothing else
};
inline constexpr std::array kMethods = {Method::kBrush,   Method::kSoft,  Method::kPaper,
                                        Method::kPrinted, Method::kCases, Method::kPoint};

std::string_view name_of(Method method) noexcept;

/// What becomes of a stroke: its data, which may break G1. Error: the method refused.
Result<StrokeData> pulled(Method method, const Pull& pull, double brush_radius_mm);

}  // namespace felt::bench
