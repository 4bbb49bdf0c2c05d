#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/drawing_guide.h"
#include "felt/document/stroke_index.h"
#include "felt/haptics/pen_sample.h"
#include "felt/session/session.h"
#include "felt/session/surface_options.h"
#include "felt/tools/contact.h"
#include "felt/tools/guide_track.h"
#include "felt/tools/picture_contours.h"
#include "felt/tools/retrace.h"
#include "felt/tools/selection_view.h"

namespace felt {

/// Parts of the session that change with the document, the pen and the options.
struct Session::Parts {
  explicit Parts(const Document& document) : index(document) {}

  StrokeIndex index;
  SelectionView selection_view;  // for tools that do not show the selection themselves
  VelocityFilter velocity;
  Contact contact;
  SurfaceOptions surface;
  Rgba ink_color;
  std::string ink_medium = "pencil";
  std::vector<DrawingGuidePtr> visible_guides;  // of the document
  std::optional<GuideTrack> guide;
  std::uint32_t guide_number = 0;  // the last number that a guide has used
  Retrace retrace;
  std::unique_ptr<PictureContours> contours;  // null: none is felt
  Retrace contour_hold{Retrace::kFirstContourHold};
};

}  // namespace felt
