#include "felt/stroke/stroke.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "bindings.h"
#include "felt/geometry/bvh.h"
#include "felt/geometry/nearest.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/edit/split.h"
#include "felt/stroke/outline/outline.h"
#include "felt/stroke/outline/outline_path.h"

namespace felt::python {

SharedStroke share(Stroke stroke) {
  return std::make_shared<Stroke>(std::move(stroke));
}

// Strokes have no function that changes them, so Python cannot change a const one.
SharedStroke share(const StrokePtr& stroke) {
  return std::const_pointer_cast<Stroke>(stroke);
}

namespace {

constexpr py::ssize_t kDouble = sizeof(double);

/// Returns the tolerance of outlines in SVG files.
double outline_tolerance() {
  return SvgOptions{}.tolerance_mm;
}

JointKind joint_of(const std::string& text) {
  if (text == "smooth") return JointKind::kSmooth;
  if (text == "corner") return JointKind::kCorner;
  throw py::value_error("joints: '" + text + "' is neither 'smooth' nor 'corner'");
}

Rgba color_of(const std::string& text) {
  const std::optional<Rgba> color = color_from_text(text);
  if (!color) throw py::value_error("color: '" + text + "' is not #rgb, #rrggbb or #rrggbbaa");
  return *color;
}

void check_tolerance(double tolerance) {
  if (tolerance > 0.0 && std::isfinite(tolerance)) return;
  throw py::value_error("tolerance: must be a finite number above 0");
}

/// Returns the control points of n x 4 x 2 numbers, in which neighbours share their joints.
std::vector<Point> control_points(const py::object& segments) {
  const py::array array = any_array(segments, "segments");
  if (array.ndim() != 3 || array.shape(0) == 0 || array.shape(1) != 4 || array.shape(2) != 2) {
    throw py::value_error("segments: must have the shape (n, 4, 2), not " +
                          py::str(array.attr("shape")).cast<std::string>());
  }
  const std::vector<Point> all = points_of(array.attr("reshape")(-1, 2), "segments");
  std::vector<Point> points{all.front()};
  for (std::size_t i = 0; i < all.size(); i += 4) {
    if (!(all[i] == points.back())) {
      throw py::value_error("segments[" + std::to_string(i / 4) +
                            "]: does not start where the segment before it ends");
    }
    points.insert(points.end(), {all[i + 1], all[i + 2], all[i + 3]});
  }
  return points;
}

std::vector<WidthKnot> knots_of(const py::object& widths, const py::object& tones) {
  const Rows rows = rows_of(widths, "widths", 2, 2);
  std::vector<WidthKnot> knots;
  knots.reserve(rows.count);
  for (std::size_t i = 0; i < rows.count; ++i) knots.push_back({rows.at(i, 0), rows.at(i, 1)});
  if (tones.is_none()) return knots;
  const py::array list = any_array(tones, "tones");
  const Rows values = rows_of(list.attr("reshape")(-1, 1), "tones", 1, 1);
  if (values.count != knots.size()) {
    throw py::value_error("tones: must have as many numbers as widths has rows (" +
                          std::to_string(knots.size()) + "), not " + std::to_string(values.count));
  }
  for (std::size_t i = 0; i < knots.size(); ++i) knots[i].tone = values.at(i, 0);
  return knots;
}

/// Makes a stroke of arrays; `data` has the other values. Without `joints`, all are corners.
SharedStroke new_stroke(const py::object& segments, const py::object& widths,
                        const py::object& tones,
                        const std::optional<std::vector<std::string>>& joints, StrokeData data) {
  check_name("medium", data.medium);
  data.points = control_points(segments);
  data.widths = knots_of(widths, tones);
  const std::size_t count = data.points.size() / 3 - (data.closed ? 0 : 1);
  if (joints) {
    for (const std::string& joint : *joints) data.joints.push_back(joint_of(joint));
  } else {
    data.joints.assign(count, JointKind::kCorner);
  }
  return share(value_of(Stroke::create(std::move(data))));
}

SharedStroke replaced(const Stroke& stroke, const std::optional<std::string>& color,
                      const std::optional<std::string>& medium, const py::object& widths,
                      const py::object& tones) {
  StrokeData data = stroke.data();
  if (color) data.color = color_of(*color);
  if (medium) {
    check_name("medium", *medium);
    data.medium = *medium;
  }
  if (!widths.is_none()) data.widths = knots_of(widths, tones);
  if (widths.is_none() && !tones.is_none()) throw py::value_error("tones: need widths as well");
  return share(value_of(Stroke::create(std::move(data))));
}

std::vector<std::string> joints_of(const Stroke& stroke) {
  std::vector<std::string> joints;
  for (const JointKind kind : stroke.data().joints) {
    joints.emplace_back(kind == JointKind::kSmooth ? "smooth" : "corner");
  }
  return joints;
}

py::object segments_of(const py::object& self) {
  const auto& stroke = self.cast<const Stroke&>();
  return view(&stroke.data().points.front().x, {stroke.segment_count(), 4, 2},
              {6 * kDouble, 2 * kDouble, kDouble}, self);
}

py::object points_view(const py::object& self) {
  const auto& points = self.cast<const Stroke&>().data().points;
  return view(&points.front().x, {static_cast<py::ssize_t>(points.size()), 2},
              {2 * kDouble, kDouble}, self);
}

py::object widths_of(const py::object& self) {
  const auto widths = self.cast<const Stroke&>().widths();
  constexpr auto kKnot = static_cast<py::ssize_t>(sizeof(WidthKnot));
  return view(&widths.front().u, {static_cast<py::ssize_t>(widths.size()), 2}, {kKnot, kDouble},
              self);
}

py::object tones_of(const py::object& self) {
  const auto widths = self.cast<const Stroke&>().widths();
  constexpr auto kKnot = static_cast<py::ssize_t>(sizeof(WidthKnot));
  return view(&widths.front().tone, {static_cast<py::ssize_t>(widths.size())}, {kKnot}, self);
}

py::object position_at(const Stroke& stroke, const py::array_t<double>& u) {
  const auto clamped = [&](double at) { return stroke.position(std::isnan(at) ? 0.0 : at); };
  if (u.ndim() == 0) {
    const Point p = clamped(*u.data());
    return py::make_tuple(p.x, p.y);
  }
  if (u.ndim() != 1) throw py::value_error("u: must be a number or a list of numbers");
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(u.size()));
  for (py::ssize_t i = 0; i < u.size(); ++i) points.push_back(clamped(u.at(i)));
  return array_of(points);
}

/// The nearest points of a stroke for many points.
struct NearestRows {
  std::vector<double> u, distance;
  std::vector<Point> points;
};

NearestRows nearest_rows(const Stroke& stroke, const std::vector<Point>& queries) {
  std::vector<BvhSegment> segments;
  segments.reserve(static_cast<std::size_t>(stroke.segment_count()));
  for (int i = 0; i < stroke.segment_count(); ++i) {
    segments.push_back({stroke.segment(i), {0, static_cast<std::uint32_t>(i)}});
  }
  SegmentBvh tree;
  tree.build(segments);
  SegmentBvh::Query query;
  query.cap = {std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
  NearestRows rows;
  for (const Point& point : queries) {
    query.point = point;
    const SegmentBvh::Hit hit = tree.nearest(query);
    rows.u.push_back(static_cast<double>(hit.ref.segment) + hit.nearest.t);
    rows.distance.push_back(std::sqrt(hit.nearest.distance_squared));
    rows.points.push_back(hit.nearest.point);
  }
  return rows;
}

py::object nearest_of(const Stroke& stroke, const py::object& point) {
  const py::object result = py::module_::import("feltline._types").attr("Nearest");
  if (!is_table(point)) {
    const NearestRows rows = nearest_rows(stroke, {point_of(point, "point")});
    return result(rows.u[0], rows.distance[0], py::make_tuple(rows.points[0].x, rows.points[0].y));
  }
  const std::vector<Point> queries = points_of(point, "point");
  NearestRows rows;
  {
    const py::gil_scoped_release release;
    rows = nearest_rows(stroke, queries);
  }
  const auto count = static_cast<py::ssize_t>(rows.u.size());
  return result(py::array_t<double>(count, rows.u.data()),
                py::array_t<double>(count, rows.distance.data()), array_of(rows.points));
}

std::vector<py::array_t<double>> outline(const Stroke& stroke, double tolerance) {
  check_tolerance(tolerance);
  Outline traced;
  {
    const py::gil_scoped_release release;
    traced = outline_of(stroke, tolerance);
  }
  std::vector<py::array_t<double>> contours;
  for (std::size_t k = 0; k < traced.contour_count(); ++k) {
    const auto contour = traced.contour(k);
    contours.push_back(array_of(std::vector<Point>(contour.begin(), contour.end())));
  }
  return contours;
}

/// Returns the data of an SVG path, in mm.
std::string path_data(const Stroke& stroke, double tolerance) {
  check_tolerance(tolerance);
  const py::gil_scoped_release release;
  std::string text;
  append_path_data(text, outline_path(stroke, tolerance));
  return text;
}

std::string svg_of(const Stroke& stroke) {
  const py::gil_scoped_release release;
  DrawingBuilder builder;
  builder.add(builder.add_layer({"Ink"}), stroke);
  return value_of(svg_ink_text(std::move(builder).build(), {}));
}

double length_of(const Stroke& stroke) {
  double length_mm = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) length_mm += arc_length(stroke.segment(i));
  return length_mm;
}

std::string stroke_text(const Stroke& stroke) {
  const int count = stroke.segment_count();
  const auto corners =
      std::count(stroke.data().joints.begin(), stroke.data().joints.end(), JointKind::kCorner);
  return "<feltline.Stroke: " + std::to_string(count) +
         (count == 1 ? " segment, " : " segments, ") + std::to_string(corners) +
         (corners == 1 ? " corner, " : " corners, ") + (stroke.closed() ? "closed, " : "") +
         stroke.medium() + ">";
}

std::size_t hash_of(const Stroke& stroke) {
  const auto& points = stroke.data().points;
  // Adding 0 makes -0 equal to 0, as for ==.
  std::size_t hash = points.size();
  for (const Point& p : points) {
    for (const double number : {p.x + 0.0, p.y + 0.0}) {
      hash = hash * 1099511628211U + std::hash<double>()(number);
    }
  }
  return hash;
}

py::tuple state_of(const py::object& self) {
  const auto& stroke = self.cast<const Stroke&>();
  return py::make_tuple(
      py::type::of(self),
      py::make_tuple(segments_of(self), widths_of(self), joints_of(stroke), stroke.closed(),
                     tones_of(self), stroke.medium(), color_to_text(stroke.color())));
}

using StrokeClass = py::class_<Stroke, std::shared_ptr<Stroke>>;

void add_values(StrokeClass& stroke) {
  stroke
      .def_property_readonly("segments", &segments_of,
                             "Control points in mm: a read-only array of shape (n, 4, 2).")
      .def_property_readonly("points", &points_view,
                             "The 3n + 1 control points, each joint once: a read-only array.")
      .def_property_readonly(
          "widths", &widths_of,
          "Rows (u, width in mm). The width is linear in u, the index of the segment plus t.")
      .def_property_readonly("tones", &tones_of,
                             "Amount of medium, 0 to 1, for each row of `widths`.")
      .def_property_readonly(
          "joints", &joints_of,
          "'smooth' or 'corner' for the n - 1 joints; n if the stroke is closed.")
      .def_property_readonly("closed", &Stroke::closed, "True if the end is joined to the start.")
      .def_property_readonly(
          "medium", [](const Stroke& s) { return s.medium(); },
          "Id of the medium, such as 'ink-pen'.")
      .def_property_readonly(
          "color", [](const Stroke& s) { return color_to_text(s.color()); },
          "'#rrggbb', or '#rrggbbaa' if the colour is translucent.")
      .def_property_readonly(
          "bounds",
          [](const Stroke& s) {
            const Rect box = s.bounds();
            return py::make_tuple(box.x0, box.y0, box.x1, box.y1);
          },
          "The box (x0, y0, x1, y1) around the ink, in mm.")
      .def_property_readonly("length", &length_of, "Length of the centre line in mm.");
}

void add_queries(StrokeClass& stroke) {
  stroke
      .def("position", &position_at, py::arg("u"),
           R"(Returns the point at u, clamped to 0..n; an array of points for an array.

>>> feltline.fit([[0, 0], [10, 0]]).position([0, 1])
array([[ 0.,  0.],
       [10.,  0.]])
)")
      .def(
          "width",
          [](const Stroke& s, const py::object& u) {
            return py::vectorize([&s](double at) { return s.width_mm(at); })(u);
          },
          py::arg("u"), "Returns the width in mm at u; an array for an array.")
      .def(
          "tone",
          [](const Stroke& s, const py::object& u) {
            return py::vectorize([&s](double at) { return s.tone(at); })(u);
          },
          py::arg("u"), "Returns the tone, 0 to 1, at u; an array for an array.")
      .def(
          "nearest", &nearest_of, py::arg("point"),
          R"(Returns the point of the centre line that is nearest to a point, or to each row of an array.

The result is a named tuple (u, distance, point), exact for every curve.

>>> feltline.fit([[0, 0], [10, 0]]).nearest((14, 3))
Nearest(u=1.0, distance=5.0, point=(10.0, 0.0))
)")
      .def("outline", &outline, py::arg("tolerance") = outline_tolerance(),
           R"(Returns the edge of the ink as closed polygons, filled with the non-zero rule.

An open stroke has one polygon. A closed stroke has two: the outside and the hole.

>>> [polygon.shape[1] for polygon in feltline.fit([[0, 0], [10, 0]]).outline()]
[2]
)")
      .def("path_data", &path_data, py::arg("tolerance") = outline_tolerance(),
           R"(Returns the edge of the ink as the data of an SVG path, in mm.

>>> feltline.fit([[0, 0], [10, 0]]).path_data()[:1]
'M'
)")
      .def("svg", &svg_of, "Returns an SVG file that shows the stroke.")
      .def("_repr_svg_", &svg_of);
}

void add_edits(StrokeClass& stroke) {
  stroke
      .def(
          "split",
          [](const Stroke& s, double u) {
            auto [first, second] = value_of(split(s, u));
            return py::make_tuple(share(std::move(first)), share(std::move(second)));
          },
          py::arg("u"),
          R"(Returns the parts of an open stroke before and after u. They share the cut point.

>>> first, second = feltline.fit([[0, 0], [10, 0]]).split(0.5)
>>> round(first.length, 6), first.position(1) == second.position(0)
(5.0, True)
)")
      .def(
          "part",
          [](const Stroke& s, double u0, double u1) {
            return share(value_of(sub_stroke(s, u0, u1)));
          },
          py::arg("u0"), py::arg("u1"),
          "Returns the part from u0 to u1. If the stroke is closed, u0 >= u1 leads through the "
          "seam.")
      .def(
          "reversed", [](const Stroke& s) { return share(reversed(s)); },
          "Returns the same stroke in the opposite direction.")
      .def("replace", &replaced, py::kw_only(), py::arg("color") = py::none(),
           py::arg("medium") = py::none(), py::arg("widths") = py::none(),
           py::arg("tones") = py::none(),
           R"(Returns a stroke with another colour, medium or widths.

>>> feltline.fit([[0, 0], [10, 0]]).replace(color="#c03020").color
'#c03020'
)");
}

}  // namespace

void bind_stroke(py::module_& module) {
  StrokeClass stroke(module, "Stroke",
                     R"(A stroke of variable width: joined cubic segments and a width profile.

A stroke never changes, so threads can share it, and a copy is the stroke itself. Lengths are in
mm, x points right, y points down. A position on a stroke is u: the index of the segment plus the
parameter of the curve, 0 to 1, in it.

`joints` defaults to corners, and `tones` to what a pencil of these widths has.

>>> stroke = feltline.Stroke([[[0, 0], [10, 0], [20, 0], [30, 0]]], [[0, 0.5], [1, 2]])
>>> stroke
<feltline.Stroke: 1 segment, 0 corners, pencil>
>>> stroke.width(0.5)
1.25
)");
  require_constructor<Stroke>();
  stroke.def(
      py::init([](const py::object& segments, const py::object& widths,
                  const std::optional<std::vector<std::string>>& joints, bool closed,
                  const py::object& tones, const std::string& medium, const std::string& color) {
        StrokeData data;
        data.closed = closed;
        data.medium = medium;
        data.color = color_of(color);
        return new_stroke(segments, widths, tones, joints, std::move(data));
      }),
      py::arg("segments"), py::arg("widths"), py::arg("joints") = py::none(),
      py::arg("closed") = false, py::arg("tones") = py::none(),
      py::arg("medium") = StrokeData{}.medium, py::arg("color") = "#000000");
  add_values(stroke);
  add_queries(stroke);
  add_edits(stroke);
  stroke
      .def(
          "__eq__", [](const Stroke& a, const Stroke& b) { return a == b; }, py::is_operator())
      .def("__hash__", &hash_of)
      .def("__len__", &Stroke::segment_count)
      .def("__repr__", &stroke_text)
      .def("__reduce__", &state_of)
      .def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::object&) { return self; });
}

}  // namespace felt::python
