#include "paper_figures.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "demo_act.h"
#include "demo_scripts.h"
#include "felt/formats/drawing_reader.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/tether.h"
#include "felt/replay/replay_machine.h"
#include "felt/replay/script_run.h"
#include "paper_samples.h"

namespace felt::cli {
namespace {

using Role = Overlay::Role;

constexpr const char* kPaperDevice = "premium";  // the PHANToM that the authors used
constexpr double kMmPerN = 30.0;                 // length of the arrow of a force
constexpr double kFigureMarginMm = 6.0;
constexpr Rgba kInk{20, 20, 24, 255}, kMetal{120, 124, 132, 255}, kPage{170, 166, 150, 255};

/// What a figure shows of a moment of a play.
struct Moment {
  SessionView view;
  PenSample pen;
  Force sent;      ///< by the device
  Force resisted;  ///< what the tool asked for: the term of the tether
};

/// Plays a script and records the moments at these times, in s.
Result<std::vector<Moment>> play_moments(const DemoAct& act, const std::vector<double>& at_s,
                                         Document start, LawForm law) {
  std::vector<Moment> moments;
  TickReport last{};
  ReplayMachine::Observer observer;
  observer.tick = [&last](const ReplayTick& tick) -> Result<void> {
    last = tick.report;
    return {};
  };
  observer.turn = [&](const Session& session, double /*fraction*/) {
    const std::size_t next = moments.size();
    if (next >= at_s.size() || 1e-9 * static_cast<double>(last.sample.time_ns) < at_s[next]) return;
    Moment moment{view_of(session, on_page(last.sample.position)), last.sample, last.sent, {}};
    for (const ForceTerms::Term& term : last.terms) {
      if (std::string_view(term.name) == "tether") moment.resisted += term.force;
    }
    moments.push_back(std::move(moment));
  };
  const ReplaySettings settings =
      replay_settings(*find_stylus_preset(kPaperDevice), typical_hand(), true, {}, {});
  ReplayMachine machine(settings, std::move(start), observer);
  const Result<void> chosen =
      machine.set_option("surface.law", law == LawForm::kPaper ? "paper" : "felt");
  if (!chosen) return tl::unexpected(chosen.error());
  ScriptRun run(machine, 1.0, 0);
  const Result<void> played =
      run.script("figure", "", read_text(act.text())).and_then([&run] { return run.play(); });
  if (!played) return tl::unexpected(played.error());
  if (moments.size() == at_s.size()) return moments;
  return fail(ErrorCode::kInvalidData, "a figure's script ended too early");
}

/// Returns a line of straight pieces.
StrokePtr line_of(const std::vector<Point>& points, double width_mm, Rgba color) {
  StrokeData data{.points = {points.front()}, .joints = {}, .widths = {}, .color = color};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Cubic c = straight(points[i - 1], points[i]);
    data.points.insert(data.points.end(), c.p.begin() + 1, c.p.end());
    if (i > 1) data.joints.push_back(JointKind::kCorner);
  }
  data.widths = {{0.0, width_mm}, {static_cast<double>(points.size() - 1), width_mm}};
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

/// Draws the workspace of a device obliquely: x to the right, y towards the viewer, z up.
Point oblique(const Vec3& p) {
  return {p.x - 0.42 * p.y, 0.5 * p.y - p.z};
}

std::vector<Point> oblique(const std::vector<Vec3>& points) {
  std::vector<Point> seen;
  for (const Vec3& p : points) seen.push_back(oblique(p));
  return seen;
}

/// Returns the line in progress, drawn obliquely on the page.
std::vector<Point> oblique_ink(const Overlay& overlay) {
  constexpr int kSteps = 12;
  constexpr double kApartMm = 0.1;
  std::vector<Point> points;
  for (const Overlay::InkSegment& segment : overlay.ink) {
    for (int i = 0; i <= kSteps; ++i) {
      const Point p = evaluate(segment.curve, static_cast<double>(i) / kSteps);
      const Point seen = oblique({p.x, p.y, 0.0});
      if (points.empty() || distance(points.back(), seen) > kApartMm) points.push_back(seen);
    }
  }
  return points;
}

/// Returns the arm of the device that holds the stylus with its tip at `tip`.
std::vector<StrokePtr> device_lines(const Vec3& tip) {
  const Vec3 gimbal = tip + Vec3{27.0, -6.0, 40.0}, elbow{92.0, 6.0, 72.0},
             shoulder{104.0, 6.0, 26};
  return {line_of(oblique({{96, 0, 0}, {120, 0, 0}, {120, 14, 0}, {96, 14, 0}, {96, 0, 0}}), 0.6,
                  kMetal),
          line_of(oblique({{108.0, 7.0, 0.0}, shoulder}), 7.0, kMetal),
          line_of(oblique({shoulder, elbow, gimbal}), 2.6, kMetal),
          line_of(oblique({tip + 0.22 * (gimbal - tip), gimbal}), 3.2, kInk),
          line_of(oblique({tip, tip + 0.24 * (gimbal - tip)}), 1.1, kInk)};
}

/// Shows the force on the pen at `at` as the only arrow.
void add_force(SessionView& view, Point at, Vec force_mm, double force_n) {
  for (Overlay::Line& line : view.overlay.lines) {
    if (line.role == Role::kVector) line.role = Role::kGuide;
  }
  view.overlay.lines.push_back({at, at + force_mm, Role::kVector});
  view.overlay.labels.push_back({at + force_mm, fmt::format("{:.2f} N", force_n)});
}

Result<PaperFigure> stylus_figure(LawForm law) {
  DemoAct act;
  act.tool("pencil");
  act.hover({22, 34});
  act.press(4.0);
  act.along({{30, 20}, {38, 30}, {46, 16}, {56, 22}}, 30.0);
  act.wait(0.6);
  const double shown_s = act.seconds();
  act.wait(0.3);
  act.lift();
  const auto moments = play_moments(act, {shown_s}, Document(), law);
  if (!moments) return tl::unexpected(moments.error());
  const Moment& now = moments->front();
  const StylusPreset& device = *find_stylus_preset(kPaperDevice);
  const PlaneOptions plane = plane_for(surface_materials().front(), device.capabilities);

  std::vector<StrokePtr> lines{
      line_of(oblique({{4, 4, 0}, {86, 4, 0}, {86, 50, 0}, {4, 50, 0}, {4, 4, 0}}), 0.7, kPage)};
  lines.push_back(line_of(oblique_ink(now.view.overlay), 1.1, kInk));
  for (StrokePtr& line : device_lines(now.pen.position)) lines.push_back(std::move(line));
  PaperFigure figure{{document_of(lines), {}, std::nullopt}, {}, {}};
  const Point tip = oblique(now.pen.position);
  const Vec3 end = now.pen.position + kMmPerN * Vec3{now.sent.x, now.sent.y, now.sent.z};
  add_force(figure.view, tip, oblique(end) - tip, norm(now.sent));
  figure.view.overlay.labels.push_back({oblique({6, 46, 0}), "surface"});
  figure.view.overlay.labels.push_back({oblique({98, 14, -8}), std::string(device.label)});
  figure.area = bounds_of(figure.view).inflated(kFigureMarginMm);
  figure.caption = fmt::format(
      "A force feedback stylus: the simulated {}, held by a simulated hand, draws on the surface. "
      "The tip is {:.3f} mm below the surface, whose spring has {:.0f} N/m, so that {:.3f} N push "
      "it out; with the friction of the pencil, the device sends {:.3f} N.",
      device.label, -now.pen.position.z, plane.stiffness_n_per_m,
      -1e-3 * plane.stiffness_n_per_m * now.pen.position.z, norm(now.sent));
  return figure;
}

Result<PaperFigure> segments_figure() {
  const Result<std::vector<StrokePtr>> strokes = cat_fitted_by(FitScheme::kPaper2002);
  const Result<std::vector<StrokePtr>> ours = cat_fitted_by(FitScheme::kFeltline);
  if (!strokes) return tl::unexpected(strokes.error());
  if (!ours) return tl::unexpected(ours.error());
  PaperFigure figure{{document_of(*strokes), {}, std::nullopt}, {}, {}};
  constexpr std::array kBands{Role::kSpan, Role::kVector, Role::kReach};
  int segments = 0, own_segments = 0;
  for (const StrokePtr& stroke : *strokes) {
    for (int i = 0; i < stroke->segment_count(); ++i, ++segments) {
      const auto k = static_cast<std::size_t>(segments) % kBands.size();
      add_span(figure.view.overlay, *stroke, i, i + 1.0, kBands[k]);
    }
    for (int i = 0; i <= stroke->segment_count(); ++i) {
      figure.view.overlay.dots.push_back({stroke->position(i), Role::kHandle});
    }
  }
  for (const StrokePtr& stroke : *ours) own_segments += stroke->segment_count();
  figure.area = bounds_of(figure.view).inflated(kFigureMarginMm);
  figure.caption = fmt::format(
      "A sketch as its Bezier segments: {} strokes as {} segments, fitted by equation 2 with s = "
      "{}. "
      "Each segment has its own band, and the dots are the ends of segments. Feltline's own fit "
      "has "
      "{} segments.",
      strokes->size(), segments, InkFitOptions{}.shared_samples, own_segments);
  return figure;
}

/// The script of figures 3 and 4: the lasso selects the head by control points, and the pen turns
/// it. Sets the times of the two figures, in s.
DemoAct turning_act(std::vector<double>& moments_s) {
  DemoAct act;
  act.tool("lasso");
  act.set("lasso.take", std::string("points"));
  act.gesture(loop_around_cats_head(), 130.0);
  act.tool("transform");
  act.set("transform.mode", std::string("rotate"));
  act.hover({84, 34});
  act.press();
  act.wait(0.3);
  act.along({{84, 38}, {83, 42}}, 12.0);
  act.wait(1.0);
  moments_s.push_back(act.seconds() - 0.2);
  act.along({{81, 46}, {78, 51}}, 6.0);
  act.wait(1.0);
  moments_s.push_back(act.seconds() - 0.2);
  act.lift();
  return act;
}

HeldHead head_of(const Moment& moment) {
  HeldHead head;
  for (const Overlay::Dot& dot : moment.view.overlay.dots) {
    if (dot.role == Role::kTether) head.anchors.push_back(dot.at);
    if (dot.role == Role::kGuide) head.centre = dot.at;
  }
  for (const Overlay::Line& line : moment.view.overlay.lines) {
    if (line.role == Role::kGuide) head.grab = line.to;
  }
  return head;
}

Result<std::vector<Moment>> turned_head(LawForm law, std::vector<double>& moments_s) {
  Result<Drawing> cat = sample_cat_drawing();
  if (!cat) return tl::unexpected(cat.error());
  const DemoAct act = turning_act(moments_s);
  return play_moments(act, moments_s, cat->document, law);
}

Result<void> add_turned_head(LawForm law, PaperFigures& figures) {
  std::vector<double> moments_s;
  Result<std::vector<Moment>> moments = turned_head(law, moments_s);
  if (!moments) return tl::unexpected(moments.error());
  figures.head = head_of(moments->front());
  Rect area;
  for (const Moment& moment : *moments) area.extend(bounds_of(moment.view));
  for (Moment& moment : *moments) {
    const double turn_rad =
        unwrapped_turn_rad(figures.head.grab - figures.head.centre,
                           on_page(moment.pen.position) - figures.head.centre, 0);
    const Force force = moment.resisted;
    PaperFigure figure{std::move(moment.view), area.inflated(kFigureMarginMm), {}};
    for (Overlay::Label& label : figure.view.overlay.labels) {
      if (label.at == on_page(moment.pen.position)) label.at = figures.head.centre;
    }
    add_force(figure.view, on_page(moment.pen.position), kMmPerN * Vec{force.x, force.y},
              norm(force));
    const std::size_t k = figures.figures.size() - 2;
    figure.caption = fmt::format(
        "Rotating a cat's head, {}. The head is turned by {:.1f} degrees, the first control points "
        "that are not selected ({} of them, the red dots) hold it, and the pen feels {:.3f} N, "
        "the arrow.",
        k == 0 ? std::string("first moment")
               : fmt::format("{:.1f} s later", moments_s[1] - moments_s[0]),
        turn_rad * 180.0 / std::numbers::pi, figures.head.anchors.size(), norm(force));
    figures.figures.push_back(std::move(figure));
  }
  return {};
}

}  // namespace

Result<Drawing> sample_cat_drawing() {
  Result<Imported> cat = parse_drawing(sample_cat(), "cat.ndjson");
  if (!cat) return tl::unexpected(cat.error());
  return std::move(cat->drawing);
}

Result<PaperFigures> paper_figures(LawForm law) {
  PaperFigures figures;
  for (Result<PaperFigure>& figure : std::array{stylus_figure(law), segments_figure()}) {
    if (!figure) return tl::unexpected(figure.error());
    figures.figures.push_back(*std::move(figure));
  }
  if (Result<void> turned = add_turned_head(law, figures); !turned)
    return tl::unexpected(turned.error());
  return figures;
}

}  // namespace felt::cli
