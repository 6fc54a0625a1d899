#pragma once

/// The environment variables by which polhode-run passes its options to the interposer.
namespace polhode::run {

inline constexpr char kSchemeVariable[] = "POLHODE_RUN_SCHEME";
/// An absolute path, "-" for standard error, or empty for no summary.
inline constexpr char kSummaryVariable[] = "POLHODE_RUN_SUMMARY";
/// Process ID of the program. Distinguishes the program from the processes that it starts, which are rotated
/// too.
inline constexpr char kProcessVariable[] = "POLHODE_RUN_PROCESS";

inline constexpr char kToStandardError[] = "-";

}  // namespace polhode::run
