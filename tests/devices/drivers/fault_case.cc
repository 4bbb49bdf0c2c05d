#include "tests/devices/drivers/fault_case.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/tools/tool.h"

namespace felt {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(Happening::kCount)> kHappenings{
    "device fault", "stall",       "double ticks", "missed ticks", "clock step",
    "suspend",      "edit silent", "undo",         "other tool",   "material",
    "bad force",    "let go",      "other model"};
constexpr std::array<std::string_view, static_cast<std::size_t>(PenState::kCount)> kStates{
    "in the air", "engaging", "in contact", "dragging", "snapped"};

/// Returns the ids of all tools.
const std::vector<std::string>& tools() {
  static const std::vector<std::string> kTools = [] {
    std::vector<std::string> ids;
    for (const auto& tool : make_tools()) ids.emplace_back(tool->info().id);
    return ids;
  }();
  return kTools;
}

struct Kind {
  Happening happening;
  InjectedFault fault = InjectedFault::kUnplugged;
};

std::vector<Kind> kinds_of(const DriverBench& bench) {
  std::vector<Kind> kinds;
  for (const InjectedFault fault : injected_faults()) {
    if (bench.shows(fault)) kinds.push_back({Happening::kDeviceFault, fault});
  }
  for (std::size_t k = 1; k < kHappenings.size(); ++k) {
    const auto happening = static_cast<Happening>(k);
    if (happening == Happening::kOtherModel && bench.other_models().empty()) continue;
    kinds.push_back({happening});
  }
  return kinds;
}

std::int64_t ms(Random& random, double from, double to) {
  return static_cast<std::int64_t>(random.between(from, to) * 1e6);
}

std::int64_t moment(PenState state, Random& random) {
  const std::int64_t landing = landing_ns(state);
  switch (state) {
    case PenState::kFree:
      return ms(random, 300.0, 600.0);
    case PenState::kEngaging:
      return landing + ms(random, 120.0, 350.0);
    case PenState::kContact:
      return landing + ms(random, 150.0, 350.0);
    case PenState::kDragging:
      return landing + ms(random, 250.0, 700.0);
    default:
      return landing + ms(random, 700.0, 880.0);
  }
}

// Chooses the delay of a service, and a duration long enough for the delay to be a fault.
void choose_service(FaultCase& fault, Random& random) {
  constexpr std::array<double, 6> kAnswersMs{1.2, 2.0, 2.1, 5.0, 12.0, 40.0};
  constexpr std::array<double, 5> kBurstsMs{1.5, 3.0, 6.0, 15.0, 30.0};
  fault.lasts_ns = ms(random, 5.0, 600.0);
  if (fault.fault == InjectedFault::kSlowAnswers) {
    fault.amount = kAnswersMs[random.bits() % kAnswersMs.size()];
  } else if (fault.fault == InjectedFault::kBurstAnswers) {
    fault.amount = kBurstsMs[random.bits() % kBurstsMs.size()];
  } else {
    fault.amount = random.between(0.2, 7.0);
  }
}

void choose_amount(FaultCase& fault, Random& random) {
  fault.lasts_ns = ms(random, 1.0, 120.0);
  fault.amount = std::pow(10.0, random.between(-1.0, 2.0));
  if (fault.happening == Happening::kDeviceFault) {
    if (fault.fault == InjectedFault::kJump) fault.amount = random.between(1.0, 50.0);
    if (fault.fault == InjectedFault::kNoise || fault.fault == InjectedFault::kCoarse) {
      fault.amount = random.between(0.05, 1.0);
    }
    if (fault.fault == InjectedFault::kJumpOften) {
      fault.amount = std::pow(10.0, random.between(1.0, 3.0));
      fault.lasts_ns = ms(random, 40.0, 300.0);
    }
    if (is_of_a_service(fault.fault)) choose_service(fault, random);
    if (fault.fault == InjectedFault::kFrozen || fault.fault == InjectedFault::kNoAnswer) {
      fault.lasts_ns = ms(random, 5.0, 500.0);
    }
  } else if (fault.happening == Happening::kStall) {
    constexpr std::array<std::int64_t, 6> kStalls{3, 8, 15, 30, 50, 500};
    fault.lasts_ns = kStalls[random.bits() % kStalls.size()] * kMs;
  } else if (fault.happening == Happening::kClockStep) {
    fault.amount = random.between(0.0, 1.0) < 0.5 ? 3600.0 : -3600.0;
  } else if (fault.happening == Happening::kBadForce) {
    fault.lasts_ns = std::max(fault.lasts_ns, 30 * kMs);  // a cross-fade may come first
    fault.amount = random.between(0.0, 1.0) < 0.5 ? 1e9 : std::numeric_limits<double>::quiet_NaN();
  } else if (fault.happening == Happening::kEditSilent) {
    fault.lasts_ns = ms(random, 300.0, 2400.0);
  }
}

}  // namespace

std::int64_t landing_ns(PenState state) noexcept {
  return (state == PenState::kEngaging ? 80 : 700) * kMs;
}

FaultCase make_fault_case(DriverBench& bench, std::uint64_t seed) {
  const std::vector<Kind> kinds = kinds_of(bench);
  const std::uint64_t index = seed % kinds.size(), turn = seed / kinds.size();
  FaultCase fault;
  fault.seed = seed;
  fault.happening = kinds[index].happening;
  fault.fault = kinds[index].fault;
  fault.tool = tools()[turn % tools().size()];
  fault.state = static_cast<PenState>((turn + index) % kStates.size());
  Random random(seed * 0x9e3779b97f4a7c15ULL + 1);
  fault.at_ns = moment(fault.state, random);
  choose_amount(fault, random);
  // A shorter fault could lie between two ticks of a slow loop, or between two looks of its driver.
  const std::int64_t period_ns = bench.world().preset().capabilities.period_ns;
  if (period_ns > kMs) fault.lasts_ns = std::max(fault.lasts_ns, period_ns + bench.notice_ns());
  return fault;
}

std::string_view kind_of(const FaultCase& fault) noexcept {
  if (fault.happening == Happening::kDeviceFault) return name_of(fault.fault);
  return kHappenings[static_cast<std::size_t>(fault.happening)];
}

std::string text_of(const FaultCase& fault) {
  char text[200];
  std::snprintf(text, sizeof text, "%.*s (%.3g) for %.1f ms at %.1f ms, %s, %.*s",
                static_cast<int>(kind_of(fault).size()), kind_of(fault).data(), fault.amount,
                1e-6 * static_cast<double>(fault.lasts_ns), 1e-6 * static_cast<double>(fault.at_ns),
                fault.tool.c_str(),
                static_cast<int>(kStates[static_cast<std::size_t>(fault.state)].size()),
                kStates[static_cast<std::size_t>(fault.state)].data());
  return text;
}

}  // namespace felt
