#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "record/drawn_body.h"
#include "record/figures.h"
#include "record/series.h"

namespace polhode::demos {

/// A comparison to be written as a page.
struct Report {
  Comparison comparison;
  std::vector<std::string> summaries;  ///< of the contenders
  std::vector<Series> series;          ///< of the contenders
  DrawnBody body;
  std::string command;  ///< the command that made it
};

/// Returns the largest number of records per contender that keeps the page under 2 MB.
std::size_t most_records(std::size_t contenders);

/// Returns the report as JSON, the data of the page; report/page/data.js reads it.
std::string report_json(const Report& report);

/// Returns the whole page, which needs no other file.
std::string report_html(const Report& report);

}  // namespace polhode::demos
