#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace polhode::run {

/// Returns the file that a shell would run, or nothing.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Returns why the interposer would not see the worlds of this program, or an empty text: it was linked statically,
/// has Bullet in itself, is for another machine, or gets other rights.
std::string reason_against(const std::filesystem::path& program);

}  // namespace polhode::run
