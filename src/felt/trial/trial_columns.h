#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "felt/trial/trial_metrics.h"

namespace felt {

/// One metric as a column of a table, and as an entry of the table's data dictionary.
struct TrialColumn {
  std::string_view
      name;  ///< the name of the member of TrialMetrics; ends in its unit if it has one
  std::string_view unit;     ///< "1" for a number without a unit
  std::string_view formula;  ///< one sentence
  std::string_view source;   ///< a DOI, or empty if Feltline defines the metric itself
  TrialMetrics::Value TrialMetrics::*value;  ///< `metrics.*column.value`
};

/// Returns all metrics, in the order of TrialMetrics.
std::span<const TrialColumn> trial_metric_columns() noexcept;

/// Returns the shortest text that reads back as the same number, or "NA" for a missing one.
std::string trial_metric_text(const TrialMetrics::Value& value);

}  // namespace felt
