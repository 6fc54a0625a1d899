#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "record/output_file.h"

namespace polhode::demos {

/// The CSV and the JSON file of a run, if asked for. The constructor checks that they can be written; they
/// appear when write() has finished.
class OutputFiles {
 public:
  OutputFiles(const std::optional<std::filesystem::path>& csv,
              const std::optional<std::filesystem::path>& json) {
    if (csv) csv_.emplace(*csv);
    if (json) json_.emplace(*json);
  }

  void write(const std::string& csv, const std::string& json) {
    if (csv_) csv_->write(csv);
    if (json_) json_->write(json);
    if (csv_) csv_->commit();
    if (json_) json_->commit();
  }

 private:
  std::optional<OutputFile> csv_;
  std::optional<OutputFile> json_;
};

}  // namespace polhode::demos
