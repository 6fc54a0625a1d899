#pragma once

/// The environment variables by which polhode-run tells the interposer what was asked for.
namespace polhode::run {

inline constexpr char kSchemeVariable[] = "POLHODE_RUN_SCHEME";
/// An absolute path, "-" for standard error, or empty for no summary.
inline constexpr char kSummaryVariable[] = "POLHODE_RUN_SUMMARY";
/// The ID of the process that was started. Processes that it starts are rotated too.
inline constexpr char kProcessVariable[] = "POLHODE_RUN_PROCESS";

inline constexpr char kToStandardError[] = "-";

}  // namespace polhode::run
