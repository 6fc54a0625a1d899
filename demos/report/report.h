#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "record/drawn_body.h"
#include "record/figures.h"
#include "record/series.h"

namespace polhode::demos {

/// A comparison as a page to look at.
struct Report {
  Comparison comparison;
  std::vector<std::string> summaries;  ///< of the contenders
  std::vector<Series> series;          ///< likewise
  DrawnBody body;
  std::string command;  ///< that made it
};

/// Returns the largest number of records in the series of so many contenders that keeps the page under 2 MB.
std::size_t most_records(std::size_t contenders);

/// The report as JSON, which the page is filled with; report/page/data.js reads it.
std::string report_json(const Report& report);

/// The whole page, which needs nothing else.
std::string report_html(const Report& report);

}  // namespace polhode::demos
