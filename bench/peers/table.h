#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "bench/peers/measure.h"

namespace felt::bench {

/// The comparison at one tolerance as a Markdown table.
void print_table(std::FILE* out, const std::vector<Row>& rows);

/// One Markdown table per source of the data: a fit that is tuned to one kind of ink shows here.
void print_sources(std::FILE* out, const std::vector<Row>& rows);

/// All rows as CSV, the sources as rows of their own.
void write_csv(const std::string& path, const std::vector<Row>& rows);

}  // namespace felt::bench
