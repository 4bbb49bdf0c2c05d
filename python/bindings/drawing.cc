#include "felt/document/drawing.h"

#include <pybind11/stl.h>

#include <limits>

#include "bindings.h"
#include "felt/document/edit_builder.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/drawing_builder.h"
#include "felt/stroke/color_text.h"

namespace felt::python {
namespace {

py::object types() {
  return py::module_::import("feltline._types");
}

StrokePtr stroke_of(const py::handle& object) {
  if (py::isinstance<Stroke>(object)) {
    static_cast<void>(object.cast<const Stroke&>());  // see require_constructor
    return object.cast<SharedStroke>();
  }
  throw py::type_error("expected a feltline.Stroke, not " +
                       py::str(py::type::of(object)).cast<std::string>());
}

void add_layer(DrawingBuilder& builder, const py::handle& layer) {
  LayerState state{layer.attr("name").cast<std::string>(), layer.attr("visible").cast<bool>(),
                   layer.attr("locked").cast<bool>()};
  state.opacity = layer.attr("opacity").cast<double>();
  if (!(state.opacity >= 0.0 && state.opacity <= 1.0)) {
    throw py::value_error("opacity: must be a number from 0 to 1");
  }
  const std::size_t index = builder.add_layer(std::move(state));
  for (const py::handle& stroke : layer.attr("strokes")) {
    builder.add(index, *stroke_of(stroke));
  }
}

Page page_of(std::pair<double, double> size, const std::string& paper) {
  Page page;
  page.width_mm = size.first;
  page.height_mm = size.second;
  for (const double mm : {page.width_mm, page.height_mm}) {
    if (mm >= Page::kMinMm && mm <= Page::kMaxMm) continue;
    throw py::value_error("page: sides must be 10 to 5000 mm long");
  }
  const std::optional<Rgba> color = color_from_text(paper);
  if (!color) throw py::value_error("paper: '" + paper + "' is not #rgb, #rrggbb or #rrggbbaa");
  page.paper = *color;
  return page;
}

ReadDrawing new_drawing(const py::iterable& content,
                        const std::optional<std::pair<double, double>>& page,
                        const std::string& paper) {
  DrawingBuilder builder;
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::size_t ink = kNone;  // the layer of strokes without a layer
  for (const py::handle& item : content) {
    if (py::isinstance(item, types().attr("Layer"))) {
      add_layer(builder, item);
      ink = kNone;
      continue;
    }
    const StrokePtr stroke = stroke_of(item);
    if (ink == kNone) ink = builder.add_layer({"Ink"});
    builder.add(ink, *stroke);
  }
  builder.drawing().page =
      page_of(page.value_or(std::pair(Page{}.width_mm, Page{}.height_mm)), paper);
  builder.drawing().has_page = page.has_value();
  return {std::move(builder).build()};
}

/// Calls visit(layer, id) for each stroke, in drawing order.
template <class Visit>
void for_each_stroke(const ReadDrawing& self, Visit visit) {
  for (const Layer& layer : self.drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) visit(layer, id);
  }
}

py::list strokes_of(const ReadDrawing& self) {
  py::list strokes;
  for_each_stroke(self, [&](const Layer&, StrokeId id) {
    strokes.append(share(self.drawing.document.find(id)));
  });
  return strokes;
}

py::list names_of(const ReadDrawing& self) {
  py::list names;
  for_each_stroke(self,
                  [&](const Layer&, StrokeId id) { names.append(name_in_file(self.drawing, id)); });
  return names;
}

py::list layers_of(const ReadDrawing& self) {
  py::list layers;
  for (const Layer& layer : self.drawing.document.layers()) {
    py::list strokes;
    for (const StrokeId id : layer.strokes) strokes.append(share(self.drawing.document.find(id)));
    layers.append(
        types().attr("Layer")(layer.name, strokes, layer.visible, layer.locked, layer.opacity));
  }
  return layers;
}

py::list notices_of(const ReadDrawing& self) {
  py::list notices;
  for (const ImportNotice& notice : self.notices) {
    notices.append(types().attr("Notice")(notice_text(notice), notice.line, notice.element,
                                          notice.what, notice.count));
  }
  return notices;
}

py::object page_size(const ReadDrawing& self) {
  if (!self.drawing.has_page) return py::none();
  return py::make_tuple(self.drawing.page.width_mm, self.drawing.page.height_mm);
}

py::object bounds_of(const ReadDrawing& self) {
  const Rect box = ink_bounds(self.drawing.document, LayerChoice::kAll);
  if (box.empty()) return py::none();
  return py::make_tuple(box.x0, box.y0, box.x1, box.y1);
}

ReadDrawing mapped(const ReadDrawing& self, const py::function& function) {
  ReadDrawing result{self.drawing};
  EditBuilder edit(self.drawing.document);
  for_each_stroke(self, [&](const Layer&, StrokeId id) {
    const StrokePtr before = self.drawing.document.find(id);
    const py::object after = function(share(before));
    if (after.is_none()) {
      edit.remove(id);
    } else if (const StrokePtr stroke = stroke_of(after); !(*stroke == *before)) {
      edit.replace(id, stroke);
    }
  });
  check(result.drawing.document.apply(std::move(edit).build("Map")));
  return result;
}

ReadDrawing with_strokes(const ReadDrawing& self, const py::iterable& strokes,
                         const std::optional<std::string>& layer) {
  const auto layers = self.drawing.document.layers();
  const Layer* target = layer ? nullptr : &layers.back();
  for (const Layer& candidate : layers) {
    if (layer && candidate.name == *layer) target = &candidate;
  }
  if (!target) throw py::value_error("layer: unknown layer '" + *layer + "'");
  ReadDrawing result{self.drawing};
  EditBuilder edit(self.drawing.document);
  for (const py::handle& stroke : strokes) edit.add(target->id, stroke_of(stroke));
  check(result.drawing.document.apply(std::move(edit).build("Add")));
  return result;
}

std::string drawing_text(const ReadDrawing& self) {
  const auto counted = [](std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  const Document& document = self.drawing.document;
  std::string text = "<feltline.Drawing: " + counted(document.stroke_count(), "stroke") + " in " +
                     counted(document.layers().size(), "layer");
  if (document.fill_count() > 0) text += ", " + counted(document.fill_count(), "fill");
  return text + ">";
}

}  // namespace

void bind_drawing(py::module_& module) {
  py::class_<ReadDrawing>(module, "Drawing",
                          R"(A drawing: strokes in layers, and a page. A drawing never changes.

`content` is an iterable of strokes, which become the layer "Ink", or of layers (feltline.Layer).
`page` is (width, height) in mm. Fills, guides, pictures and materials of a file are kept, but
cannot be changed here.

>>> drawing = feltline.Drawing([feltline.fit([[0, 0], [10, 0]])], page=(210, 297))
>>> drawing
<feltline.Drawing: 1 stroke in 1 layer>
>>> drawing.map(lambda stroke: stroke.replace(color="#c03020")).strokes[0].color
'#c03020'
)")
      .def(py::init(&new_drawing), py::arg("content") = py::tuple(), py::kw_only(),
           py::arg("page") = py::none(), py::arg("paper") = "#ffffff")
      .def_property_readonly("strokes", &strokes_of,
                             "All strokes, those of hidden layers too, the lowest first.")
      .def_property_readonly(
          "names", &names_of,
          "The name of each stroke in files: 's12', or that of the file that was read.")
      .def_property_readonly("layers", &layers_of, "The layers, the lowest first.")
      .def_property_readonly("page", &page_size, "(width, height) in mm, or None.")
      .def_property_readonly(
          "paper", [](const ReadDrawing& d) { return color_to_text(d.drawing.page.paper); },
          "Colour of the page: '#rrggbb'.")
      .def_property_readonly(
          "surface", [](const ReadDrawing& d) { return d.drawing.page.surface; },
          "Id of the surface, or '' if none was chosen.")
      .def_property_readonly("bounds", &bounds_of,
                             "The box (x0, y0, x1, y1) around all ink in mm, or None.")
      .def_property_readonly(
          "fill_count", [](const ReadDrawing& d) { return d.drawing.document.fill_count(); },
          "Number of coloured areas.")
      .def_property_readonly(
          "format", [](const ReadDrawing& d) { return d.format; },
          "Name of the format of the file, or '' if the drawing was not read from one.")
      .def_property_readonly(
          "is_exact", [](const ReadDrawing& d) { return d.is_exact; },
          "True unless the file had content that was skipped, changed or fitted.")
      .def_property_readonly("notices", &notices_of,
                             "What the reader skipped or changed, as counted feltline.Notice.")
      .def("map", &mapped, py::arg("function"),
           R"(Returns the drawing with function(stroke) in place of each stroke.

If the function returns None, the stroke is removed.)")
      .def(
          "add", &with_strokes, py::arg("strokes"), py::arg("layer") = py::none(),
          "Returns the drawing with more strokes on top of a layer: the named one, or the highest.")
      .def(
          "__eq__",
          [](const ReadDrawing& a, const ReadDrawing& b) { return a.drawing == b.drawing; },
          py::is_operator())
      .def("__len__", [](const ReadDrawing& d) { return d.drawing.document.stroke_count(); })
      .def("__iter__", [](const ReadDrawing& d) { return py::iter(strokes_of(d)); })
      .def("__repr__", &drawing_text)
      .def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::object&) { return self; });
  require_constructor<ReadDrawing>();
}

}  // namespace felt::python
