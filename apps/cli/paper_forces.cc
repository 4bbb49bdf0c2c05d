#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/bricks/tether.h"
#include "felt/replay/replay_machine.h"
#include "paper_equations.h"

namespace felt::cli {
namespace {

PenSample resting_at(Point p) {
  PenSample sample;
  sample.position = {p.x, p.y, -1.0};
  return sample;
}

/// Returns the force of a brick on a resting pen.
template <class Brick>
Force force_at(const Brick& brick, Point p) {
  ForceMemory memory;
  return brick(resting_at(p), memory);
}

ForceLaw in_form(ForceLaw law, LawForm form) {
  law.form = form;
  return law;
}

/// Returns the smallest distance at which the law reaches this force, by halving.
double reached_at_mm(const ForceLaw& law, double force_n) {
  double low = 0.0, high = 1e9;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (law.force_n(middle) < force_n ? low : high) = middle;
  }
  return high;
}

/// Returns by how much the force of a pull changes, peak to peak, in the hand of somebody who holds
/// the PHANToM with a light grip, pulls a line by 4 mm, comes back, and then rests for two seconds
/// with an aim 0.5 mm from where the pen grabbed the line. The first second does not count.
Result<double> unrest_n(LawForm form) {
  double low = 1e9, high = -1e9;
  ReplayMachine::Observer observer;
  observer.tick = [&](const ReplayTick& tick) -> Result<void> {
    const double seconds = 1e-9 * static_cast<double>(tick.report.sample.time_ns);
    for (const ForceTerms::Term& term : tick.report.terms) {
      if (std::string_view(term.name) != "edit" || seconds < 3.5 || seconds > 4.5) continue;
      low = std::min(low, term.force.y);
      high = std::max(high, term.force.y);
    }
    return {};
  };
  const StrokePtr line = std::make_shared<const Stroke>(
      Stroke::create({.points = {{10, 10}, {20, 10}, {30, 10}, {40, 10}},
                      .joints = {},
                      .widths = {{0.0, 1.0}, {1.0, 1.0}}})
          .value());
  ReplayMachine machine(
      replay_settings(*find_stylus_preset("premium"), *find_hand("light"), true, {}, {}),
      document_of({&line, 1}), observer);
  Result<void> done =
      machine.set_option("surface.law", form == LawForm::kPaper ? "paper" : "felt").and_then([&] {
        return machine.set_option("surface.material", "glass");
      });
  const auto add = [&](double s, const decltype(Event::what)& what) {
    if (done) done = machine.add({std::llround(1e9 * s), what});
  };
  add(0.0, SelectTool{"pull"});
  add(0.0, HandEvent{{25.0, 10.0, 5.0}, {}});
  add(1.0, HandEvent{{25.0, 10.0, 5.0}, {}});
  add(1.2, HandEvent{{25.0, 10.0, -3.0}, {}});
  add(1.5, HandEvent{{25.0, 10.0, -3.0}, {}});
  add(1.9, HandEvent{{25.0, 14.0, -3.0}, {}});
  add(2.5, HandEvent{{25.0, 10.5, -3.0}, {}});
  add(4.5, HandEvent{{25.0, 10.5, -3.0}, {}});
  if (done) done = machine.play();
  if (!done) return tl::unexpected(done.error());
  return std::max(high - low, 0.0);
}

std::string newtons(double force_n) {
  return fmt::format("{:.4f}", force_n);
}

Result<std::vector<PaperEquation>> edit_equations() {
  const EditOptions printed{.law = in_form(kEditLaw, LawForm::kPaper)}, read;
  std::vector<std::vector<std::string>> rows;
  for (const double mm : {0.001, 0.1, 0.5, 0.667, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    const Force literal = force_at(EditSpring({0, 0}, printed), {mm, 0.0});
    const Force ours = force_at(EditSpring({0, 0}, read), {mm, 0.0});
    rows.push_back({fmt::format("{}", mm), newtons(norm(literal)), newtons(norm(ours))});
  }
  const Result<double> unrest = unrest_n(LawForm::kPaper), rest = unrest_n(LawForm::kFelt);
  if (!unrest) return tl::unexpected(unrest.error());
  if (!rest) return tl::unexpected(rest.error());
  const double half_mm = reached_at_mm(kEditLaw, 0.6);
  return std::vector<PaperEquation>{
      {"(8)", "F = -l(V)", "F = -phi(|V|) V/|V|, phi(d) = min(l(d), 0.3 d) N, d in mm", "E6, E21",
       fmt::format(
           "Both are 0 N at V = 0; at 0.001 mm, {:.4f} N as printed and {:.4f} N as read. If a "
           "light hand "
           "rests near the grab of a line on the simulated PHANToM, the force changes by {:.3f} "
           "N, peak to peak, as printed and by {:.3f} N as read.",
           printed.law.force_n(0.001), read.law.force_n(0.001), *unrest, *rest),
       markdown_table({"V, mm", "F as printed, N", "F as read, N"}, rows)},
      {"(9)", "0.2 N <= F <= 1 N; V1 < V1 => l(V1) < l(V1)",
       "V1 < V2 => l(V1) < l(V2); l(d) = 0.2 + 0.8 d/(d + 10) N", "E6",
       fmt::format(
           "As read, 0.2 N are reached at {:.4f} mm, 0.6 N at {:.4f} mm, 0.99 N at {:.1f} mm "
           "and 1 N never: {:.6f} N at 1 km.",
           reached_at_mm(kEditLaw, 0.2), half_mm, reached_at_mm(kEditLaw, 0.99),
           kEditLaw.force_n(1e6)),
       ""}};
}

Point mean_of(const std::vector<Point>& points) {
  Vec sum{};
  for (const Point p : points) sum += p - points.front();
  return points.front() + (1.0 / static_cast<double>(points.size())) * sum;
}

Tether printed_move(const HeldHead& head) {
  return Tether::translation(head.grab, static_cast<int>(head.anchors.size()))
      .printed(mean_of(head.anchors));
}

double sum_of_radii_mm(const HeldHead& head) {
  double sum = 0.0;
  for (const Point p : head.anchors) sum += distance(p, head.centre);
  return sum;
}

std::string move_table() {
  constexpr double kMoveMm = 10.0;
  std::vector<std::vector<std::string>> rows;
  for (const int count : {0, 1, 2, 4, 8, 16}) {
    const double force_n = norm(force_at(Tether::translation({0, 0}, count), {kMoveMm, 0.0}));
    // The anchors of the printed form are in a ring around the grabbed point, so they cancel there.
    const Tether ring = Tether::translation({0, 0}, count).printed({0, 0});
    rows.push_back({fmt::format("{}", count), newtons(norm(force_at(ring, {0, 0}))),
                    newtons(norm(force_at(ring, {kMoveMm, 0.0}))), newtons(force_n)});
  }
  return markdown_table({"N curves, moved by 10 mm",
                         "a ring of anchors before any movement, "
                         "as printed, N",
                         "after it, as printed, N", "after it, as read, N"},
                        rows);
}

std::string turn_table(const HeldHead& head) {
  const double radii = sum_of_radii_mm(head);
  std::vector<std::vector<std::string>> rows;
  for (const double deg : {1.0, 10.0, 30.0, 90.0, 180.0, 270.0, 359.0}) {
    const Tether tether = Tether::rotation(head.centre, head.grab, radii, 1);
    const Tether literal = tether.printed(mean_of(head.anchors));
    // The turn is followed in small steps, so that it counts beyond 180 degrees.
    ForceMemory memory, literal_memory;
    Force force, literal_force;
    const Vec arm = head.grab - head.centre;
    for (int i = 0; i <= 100; ++i) {
      const double th = deg * std::numbers::pi / 180.0 * i / 100.0;
      const PenSample pen =
          resting_at(head.centre + Vec{arm.x * std::cos(th) - arm.y * std::sin(th),
                                       arm.x * std::sin(th) + arm.y * std::cos(th)});
      force = tether(pen, memory);
      literal_force = literal(pen, literal_memory);
    }
    rows.push_back(
        {fmt::format("{:.0f}", deg), newtons(norm(literal_force)), newtons(norm(force))});
  }
  return markdown_table({fmt::format("turn of the head, degrees (sum of radii {:.3f} mm)", radii),
                         "F as printed (chords), N", "F as read (arcs), N"},
                        rows);
}

std::string scale_table(const HeldHead& head) {
  const double radii = sum_of_radii_mm(head);
  std::vector<std::vector<std::string>> rows;
  for (const double s : {0.5, 0.8, 1.25, 2.0}) {
    const Tether tether = Tether::scale(head.centre, head.grab, radii);
    const Point pen = head.centre + s * (head.grab - head.centre);
    rows.push_back({fmt::format("{}", s),
                    newtons(norm(force_at(tether.printed(mean_of(head.anchors)), pen))),
                    newtons(norm(force_at(tether, pen)))});
  }
  return markdown_table({"scale of the head", "F as printed, N", "F as read, N"}, rows);
}

PaperEquation tether_equation(const HeldHead& head) {
  const Tether literal = printed_move(head);
  const Tether ours = Tether::translation(head.grab, static_cast<int>(head.anchors.size()));
  const double sum_mm =
      static_cast<double>(head.anchors.size()) * distance(head.grab, mean_of(head.anchors));
  return {
      "(10)",
      "V1 = (x,y,z) - B1, V4 = (x,y,z) - B4, F = -l(V1 + V4)",
      "V_i = T(B_i) - B_i, what the fixed point would have moved; F = -phi(sum) against the "
      "movement, D = 40 mm",
      "E14, E15, E16",
      fmt::format("The {} points that hold the cat's head pull with {:.4f} N as printed when it "
                  "is grabbed, before anything moves (sum {:.3f} mm), and with {:.4f} N as read.",
                  head.anchors.size(), norm(force_at(literal, head.grab)), sum_mm,
                  norm(force_at(ours, head.grab))),
      move_table() + "\n" + turn_table(head) + "\n" + scale_table(head)};
}

PaperEquation snap_equation() {
  const WellShape well;
  const SnapWells literal(Point{0, 0}, well.printed(1.0)), ours(Point{0, 0}, well);
  std::vector<std::vector<std::string>> rows;
  for (const double mm : {0.0, 0.01, 0.5, 1.0, 2.0, 4.0, 6.0, 7.0, 7.99, 8.0, 9.0}) {
    rows.push_back({fmt::format("{}", mm), newtons(norm(force_at(literal, {mm, 0.0}))),
                    newtons(norm(force_at(ours, {mm, 0.0})))});
  }
  const double inside_mm = well.radius_mm - 1e-6;
  return {
      "(11)",
      "V = P0 - (x,y,z), F = l(V) if V < M",
      "a profile that is 0 at both ends, at most 0.6 N, M = 8 mm",
      "E17",
      fmt::format("As printed, the force jumps by {:.4f} N at M = {} mm and is largest there, and "
                  "by {:.4f} N at P0; as read, the jumps are {:.4f} and {:.4f} N.",
                  norm(force_at(literal, {inside_mm, 0.0})), well.radius_mm,
                  norm(force_at(literal, {1e-6, 0.0})), norm(force_at(ours, {inside_mm, 0.0})),
                  norm(force_at(ours, {1e-6, 0.0}))),
      markdown_table({"V, mm", "F as printed, N", "F as read, N"}, rows)};
}

}  // namespace

Result<std::vector<PaperEquation>> paper_forces(const HeldHead& head) {
  if (head.anchors.empty()) return fail(ErrorCode::kInvalidData, "nothing holds the cat's head");
  Result<std::vector<PaperEquation>> equations = edit_equations();
  if (!equations) return equations;
  equations->push_back(tether_equation(head));
  equations->push_back(snap_equation());
  return equations;
}

}  // namespace felt::cli
