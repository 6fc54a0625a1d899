#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace polhode::run {

/// Returns the file that a shell would run for this name, or nothing.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Returns the reason why the interposer cannot intercept the program, or an empty text. Reasons: the program
/// is linked statically, contains Bullet, is for another machine, or runs with other rights.
std::string reason_against(const std::filesystem::path& program);

}  // namespace polhode::run
