#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode::demos {

/// Encodes as in RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

/// Encodes the numbers as IEEE 754 single precision, least significant byte first.
std::string base64(const std::vector<float>& numbers);

}  // namespace polhode::demos
