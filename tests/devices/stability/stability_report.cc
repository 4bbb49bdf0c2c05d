#include <algorithm>
#include <cstdio>
#include <map>

#include "tests/devices/stability/stability_matrix.h"

namespace felt {
namespace {

constexpr std::string_view kListBegin = "```failing\n";
constexpr std::string_view kListEnd = "```\n";

std::string fixed(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// Summary of a block of cells: the number of failures and the largest values.
struct Summary {
  int cells = 0;
  int failing = 0;
  double high_frequency_n = 0.0;
  double energy_mj = 0.0;

  void add(const StabilityResult& r) {
    ++cells;
    failing += passes(r) ? 0 : 1;
    high_frequency_n = std::max(high_frequency_n, r.high_frequency_n);
    energy_mj = std::max(energy_mj, r.energy_mj);
  }
};

// Summaries by row and column name. Rows and columns appear in the sequence of their first cell.
class Table {
 public:
  void add(std::string_view row, std::string_view column, const StabilityResult& result) {
    const auto place = [](std::vector<std::string>& names, std::string_view name) {
      const auto at = std::find(names.begin(), names.end(), name);
      const auto index = static_cast<std::size_t>(at - names.begin());
      if (at == names.end()) names.emplace_back(name);
      return index;
    };
    const std::size_t r = place(rows_, row);
    summaries_[{r, place(columns_, column)}].add(result);
  }
  [[nodiscard]] std::string text(const std::string& corner) const {
    std::string out = "| " + corner;
    for (const std::string& column : columns_) out += " | " + column;
    out += " |\n|---";
    for (std::size_t i = 0; i < columns_.size(); ++i) out += "|---";
    out += "|\n";
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      out += "| " + rows_[r];
      for (std::size_t c = 0; c < columns_.size(); ++c) out += " | " + entry(summaries_.at({r, c}));
      out += " |\n";
    }
    return out + "\n";
  }

 private:
  static std::string entry(const Summary& s) {
    std::string text = fixed(s.high_frequency_n, 3) + " N, " + fixed(s.energy_mj, 2) + " mJ";
    if (s.failing > 0) {
      text += ", **" + std::to_string(s.failing) + " of " + std::to_string(s.cells) + "**";
    }
    return text;
  }

  std::vector<std::string> rows_, columns_;
  std::map<std::pair<std::size_t, std::size_t>, Summary> summaries_;
};

std::string loop_of(const StabilityCell& cell) {
  return rate_name(cell.period_ns) + ", delay " + std::to_string(cell.delay_ticks);
}

constexpr const char* kIntroduction = R"(# Stability
The forces that a hand feels when it should feel none. Written by `./dev bench stability`; a test
runs a part of it and requires that the same cells fail as are listed here.

Every cell is a trial: the simulated stylus in a simulated hand, the loop with its safety chain and
the tools' force terms, in virtual time. *rest*: land, press 0.8 N, hold still. *slow*: press and
move at 20 mm/s (smooth surface: grain is meant to be felt). *tap*: eight taps. *well*: rest 1 mm
beside a snap target, then out to its plateau and back. *edit*: an edit spring, 20 mm out and back.
*guide*: rest 1 mm beside a straight groove, then to 3 mm and back. *ridge*: the same beside the
ridge of Fill, which pushes away, with Fill's share of the friction. *bundle*: the widest bundle of
Gather, with Gather's share of the friction, 20 mm out and back. *shake*: 20 mm out and back by a
hand that shakes by 1 mm at 5 Hz, with the damping of the steady hand at full strength. *hold*: rest
where the pencil holds the pen while it offers a shape, then out of the hold and back. *read*: rest 1
mm beside the end of a line with the groove and the notch of Read, which has no friction on any
surface, then to 3 mm and back. *let go*: a typical hand lands lightly and lets go; measured after
the pen has come to rest; for *tap*, after it has fallen and bounced.

Pencil and eraser in every loop; all other media at 1 kHz with a delay of one tick. The HapticMASTER
accepts a force every 4 ms, so its only loop has 250 Hz. A joystick has no surface: it is in the second
part only, with its own delay of 7 ticks.

Two figures. **HF**: rms of the device's force above 30 Hz over all axes, clean below 0.03 N (the
smallest force that is perceived is 0.04 N). **Energy**: the net work of the device's force on the
hand over a contact or a closed movement; at most 1 mJ. A trial also fails when the safety chain
finds a fault.

Each entry is the worst HF and the worst energy of all cells of that kind, and the number of cells
that fail.

)";

constexpr const char* kGuides = R"(## Guides of a drawing
The trial *guide* with each kind of [guide of a drawing](design/forces.md#guides-of-a-drawing), on
all simulated devices (mice and a tablet have no force), with the friction that a pencil has
while such a guide acts. *ruler*: the pen comes from the free side and is pushed beyond the edge.
*line*: also one of parallels or a leg of a set square. *ellipse*: its narrow end, with a radius of
5 mm. *perspective*: begins with a click. *ray* and *node*: the pen crosses the well of 0.3 N.
*teacher*: leads with up to 0.2 N. *ring*: a well of a [ring](design/forces.md#rings), without
friction; the pen leaves it and comes back. *edge*: the ridge at the [edge of the
page](design/forces.md#edges), with the whole friction. *click*: rest at a depth that
[clicks](design/forces.md#clicks), then press through another one, 0.3 mm deeper, and come back.
*flank*: rest on the flank of a [body](design/solids.md#touch), a ball of 80 mm with 4,900 triangles,
then to where it is 43 degrees steep and back. *slide*: 20 mm/s over its facets.
Paper, pencil, 1 kHz with delays of 0, 1 and 2 ticks, and 5 kHz with 1 tick.

)";

constexpr const char* kWhatFails = R"(
Why, by kind:

* **worst; well, edit, guide, trace or teacher; most of them at 1 kHz with 1 or 2 ticks of delay in a
  light hand or none: 0.03 to 0.04 N.**
  This simulated device has no friction. The pen is held by two springs in the surface, the
  friction's bristle and the target, edit or guide, which together use the whole budget of [the
  design](design/limits.md#stiffness-budget) (900 N/m, or 600 N/m with 2 ticks of delay). Dampers in
  the surface do not act below 6 mm/s, because one step of this sensor looks like 12 mm/s. A swing
  of about 0.1 mm at about 25 Hz is therefore not damped by the loop, and a light hand or no hand
  does not damp it either. It does not grow.

* **hapticmaster; well, guide, ridge, hold, read and guides of a drawing; a light or soft hand or none: 1 to
  4.05 mJ.** Nothing hums (at most 0.012 N) and no fault occurs. A virtual mass of 3 kg swings for
  seconds in a hand of 30 or 100 N/m, and forces that are held for 4 ms act late; 4.05 mJ is the energy
  of 3 kg at 52 mm/s. In a typical or firm hand, every trial passes: hold the handle firmly.

No other device fails. Earlier versions failed on others: planes and bristles hummed at 0.03 to 0.06
N between two steps of coarse sensors (touch, falcon), until both were made softer there
(`drawing_feel.h`).

)";

}  // namespace

std::string stability_report(const std::vector<StabilityCell>& cells,
                             const std::vector<StabilityResult>& results) {
  Table by_device, by_hand, by_loop, by_surface;
  Table guides_by_device, guides_by_hand, guides_by_loop;
  std::string failing;
  int count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const StabilityCell& c = cells[i];
    const std::string_view trial = name_of(c.trial);
    const bool is_guide = is_guide_of_drawing(c.trial);
    const std::string_view hand = c.hand != nullptr ? c.hand->name : "let go";
    (is_guide ? guides_by_device : by_device).add(c.device->name, trial, results[i]);
    (is_guide ? guides_by_hand : by_hand).add(hand, trial, results[i]);
    (is_guide ? guides_by_loop : by_loop).add(loop_of(c), trial, results[i]);
    if (!is_guide) {
      const std::string tool = std::string(c.surface->id) + ", " + std::string(c.tool->id);
      by_surface.add(tool, trial, results[i]);
    }
    if (passes(results[i])) continue;
    ++count;
    failing += name_of(c) + ": " + fixed(results[i].high_frequency_n, 3) + " N, " +
               fixed(results[i].energy_mj, 2) + " mJ";
    if (results[i].fault != SafetyFault::kNone) failing += ", fault";
    failing += '\n';
  }
  std::string out = kIntroduction;
  out += by_device.text("device") + by_hand.text("hand") + by_loop.text("loop") +
         by_surface.text("surface, tool");
  out += kGuides + guides_by_device.text("device") + guides_by_hand.text("hand") +
         guides_by_loop.text("loop");
  out += "## What fails: " + std::to_string(count) + " of " + std::to_string(cells.size()) + "\n";
  out += kWhatFails;
  out += kListBegin;
  out += failing;
  out += kListEnd;
  return out;
}

std::vector<std::string> failing_names(const std::string& report) {
  std::vector<std::string> names;
  const std::size_t begin = report.find(kListBegin);
  if (begin == std::string::npos) return names;
  std::size_t at = begin + kListBegin.size();
  while (at < report.size() && report.compare(at, kListEnd.size(), kListEnd) != 0) {
    const std::size_t end = report.find('\n', at);
    if (end == std::string::npos) break;
    names.push_back(report.substr(at, report.find(':', at) - at));
    at = end + 1;
  }
  return names;
}

}  // namespace felt
