#include "recording.h"

#include <pybind11/stl.h>

#include <optional>

#include "bindings.h"
#include "felt/base/read_file.h"
#include "felt/formats/drawing_reader.h"
#include "felt/io/events/event_reader.h"
#include "felt/io/events/event_writer.h"
#include "felt/store/felt_file.h"

namespace felt::python {
namespace {

SampleRow row_of(const RecordedSample& sample) {
  const PenSample pen = sample_of(sample.time_ns, sample.pen);
  SampleRow row;
  row.t_ms = static_cast<double>(pen.time_ns) / kNsPerMs;
  row.x = pen.position.x;
  row.y = pen.position.y;
  row.z = pen.position.z;
  row.pressure = pen.pressure.value_or(kUnknown);
  row.tilt = pen.tilt_deg.value_or(kUnknown);
  row.buttons = pen.buttons;
  row.contact = in_contact(pen) ? 1 : 0;
  const RecordedForces unknown{{kUnknown, kUnknown, kUnknown}, {kUnknown, kUnknown, kUnknown}};
  const RecordedForces forces = sample.forces.value_or(unknown);
  row.ask_x = forces.asked.x;
  row.ask_y = forces.asked.y;
  row.ask_z = forces.asked.z;
  row.sent_x = forces.sent.x;
  row.sent_y = forces.sent.y;
  row.sent_z = forces.sent.z;
  return row;
}

py::dtype row_type() {
  py::list names, formats, offsets;
  const auto add = [&](const char* name, const char* format, std::size_t offset) {
    names.append(name);
    formats.append(py::dtype::from_args(py::str(format)));
    offsets.append(offset);
  };
  add("t_ms", "f8", offsetof(SampleRow, t_ms));
  add("x", "f8", offsetof(SampleRow, x));
  add("y", "f8", offsetof(SampleRow, y));
  add("z", "f8", offsetof(SampleRow, z));
  add("pressure", "f8", offsetof(SampleRow, pressure));
  add("tilt", "f8", offsetof(SampleRow, tilt));
  add("buttons", "u4", offsetof(SampleRow, buttons));
  add("contact", "?", offsetof(SampleRow, contact));
  add("ask_x", "f8", offsetof(SampleRow, ask_x));
  add("ask_y", "f8", offsetof(SampleRow, ask_y));
  add("ask_z", "f8", offsetof(SampleRow, ask_z));
  add("sent_x", "f8", offsetof(SampleRow, sent_x));
  add("sent_y", "f8", offsetof(SampleRow, sent_y));
  add("sent_z", "f8", offsetof(SampleRow, sent_z));
  return {names, formats, offsets, sizeof(SampleRow)};
}

py::array samples_view(const py::object& self) {
  const auto& rows = self.cast<const HeldRecording&>().rows;
  py::array array(row_type(), {static_cast<py::ssize_t>(rows.size())},
                  {static_cast<py::ssize_t>(sizeof(SampleRow))}, rows.data(), self);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Returns the events as dictionaries with the keys of docs/formats/events.md.
py::list events_of(const HeldRecording& self) {
  const py::object loads = py::module_::import("json").attr("loads");
  py::list events;
  std::string line;
  for (const RecordedEvent& event : self.recording.events) {
    line.clear();
    append_event_line(line, event.event);
    events.append(loads(py::str(line)));
  }
  return events;
}

/// Returns the samples of each touch, as rows that fit() reads.
py::list touches_of(const HeldRecording& self) {
  py::list touches;
  std::vector<InkSample> touch;
  const auto end = [&] {
    if (!touch.empty()) touches.append(array_of(touch));
    touch.clear();
  };
  for (const RecordedSample& sample : self.recording.samples) {
    const PenSample pen = sample_of(sample.time_ns, sample.pen);
    if (!in_contact(pen)) {
      end();
      continue;
    }
    touch.push_back({{pen.position.x, pen.position.y}, pen.pressure, pen.time_ns, pen.tilt_deg});
  }
  end();
  return touches;
}

py::object to_pandas(const py::object& self) {
  py::object frame;
  try {
    frame = py::module_::import("pandas").attr("DataFrame");
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ImportError)) throw;
    throw py::import_error(
        "to_pandas() needs pandas; install it (python3-pandas), or use the "
        "numpy array `samples`");
  }
  return frame(samples_view(self));
}

std::string recording_text(const HeldRecording& self) {
  const auto& rows = self.rows;
  const double ms = rows.empty() ? 0.0 : rows.back().t_ms - rows.front().t_ms;
  return "<feltline.Recording: " + std::to_string(rows.size()) + " samples, " +
         std::to_string(self.recording.events.size()) + " other events, " +
         py::str(py::module_::import("builtins").attr("format")(ms / 1000.0, ".3f"))
             .cast<std::string>() +
         " s>";
}

/// Reads an event script as a recording without forces.
Result<FeltRecording> script_recording(const std::string& path, std::string_view bytes) {
  FeltRecording recording;
  ScriptSink sink;
  sink.event = [&recording](const Event& event) -> Result<void> {
    if (const auto* pen = std::get_if<PenEvent>(&event.what)) {
      recording.samples.push_back({event.time_ns, *pen, std::nullopt});
    } else {
      recording.events.push_back({recording.samples.size(), event});
    }
    return {};
  };
  Result<void> done = read_script(path, read_text(bytes), sink);
  if (!done) return tl::unexpected(done.error());
  return recording;
}

/// Checks the first bytes of a file with recordings or a script (HeadCheck).
Result<std::size_t> check_recording_head(std::string_view head, std::uint64_t size) {
  const std::optional<FileFormat> format = format_of_bytes(head);
  if (format == FileFormat::kFelt) return check_felt_head(head, size);
  return format ? kMaxFeltBytes : kMaxUnrecognisedBytes;
}

Result<std::vector<FeltRecording>> recordings_in(const std::string& path) {
  const Result<std::string> bytes = read_regular_file(path, check_recording_head);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto head = std::string_view(*bytes).substr(0, kFormatHeadBytes);
  if (format_of_bytes(head) != FileFormat::kFelt) {
    return script_recording(path, *bytes).map([](FeltRecording recording) {
      return std::vector<FeltRecording>{std::move(recording)};
    });
  }
  const Result<Drawing> drawing = parse_felt(*bytes);
  if (!drawing) return tl::unexpected(with_context(drawing.error(), path));
  const Result<std::vector<RecordingInfo>> all = recordings_of(*drawing);
  if (!all) return tl::unexpected(with_context(all.error(), path));
  std::vector<FeltRecording> recordings;
  for (std::size_t i = 0; i < all->size(); ++i) {
    Result<FeltRecording> recording = read_recording(*drawing, i);
    if (!recording) return tl::unexpected(with_context(recording.error(), path));
    recordings.push_back(*std::move(recording));
  }
  return recordings;
}

py::list read_recordings(const std::string& path) {
  std::vector<std::unique_ptr<HeldRecording>> held;
  {
    const py::gil_scoped_release release;
    for (FeltRecording& recording : value_of(recordings_in(path))) {
      held.push_back(std::make_unique<HeldRecording>(std::move(recording)));
    }
  }
  py::list list;
  for (auto& recording : held) list.append(std::move(recording));
  return list;
}

}  // namespace

HeldRecording::HeldRecording(FeltRecording from) : recording(std::move(from)) {
  rows.reserve(recording.samples.size());
  for (const RecordedSample& sample : recording.samples) rows.push_back(row_of(sample));
}

void bind_recording(py::module_& module) {
  py::class_<HeldRecording>(module, "Recording",
                            R"(How a drawing was made: the samples of the pen and all other events.

feltline.read_recordings() reads recordings; they never change.)")
      .def_property_readonly("samples", &samples_view,
                             R"(The pen samples: a read-only structured array. NaN means unknown.

t_ms             time since the session began
x, y, z          position in mm; z points out of the surface
pressure, tilt   0 to 1, and degrees from the upright
buttons          bit i is set while button i is down
contact          True while the pen touches the surface
ask_x ... ask_z      force that the tool requested, N
sent_x ... sent_z    force that the device received, N)")
      .def_property_readonly("events", &events_of,
                             "All other events as dictionaries (docs/formats/events.md).")
      .def_property_readonly(
          "device", [](const HeldRecording& r) { return r.recording.device; },
          "Source of the samples, or '' if the file does not say.")
      .def_property_readonly(
          "period_ms",
          [](const HeldRecording& r) {
            return static_cast<double>(r.recording.period_ns) / kNsPerMs;
          },
          "Period of the haptic loop.")
      .def("touches", &touches_of, "Returns the samples of each touch, as arrays for fit().")
      .def("to_pandas", &to_pandas,
           "Returns `samples` as a pandas.DataFrame. Raises ImportError if pandas is missing.")
      .def(
          "__eq__",
          [](const HeldRecording& a, const HeldRecording& b) { return a.recording == b.recording; },
          py::is_operator())
      .def("__len__", [](const HeldRecording& r) { return r.rows.size(); })
      .def("__repr__", &recording_text);
  require_constructor<HeldRecording>();
  module.def("read_recordings", &read_recordings);
}

}  // namespace felt::python
