#pragma once

#include <string_view>

namespace polhode::demos {

/// Returns the report's page as joined by assemble.cmake from page/, with @REPORT_DATA@ in place of the data.
std::string_view page_template();

}  // namespace polhode::demos
