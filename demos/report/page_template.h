#pragma once

#include <string_view>

namespace polhode::demos {

/// The report's page with @REPORT_DATA@ where its data go, as assemble.cmake joins it from page/.
std::string_view page_template();

}  // namespace polhode::demos
