#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workprecision/cell_map.h"

namespace polhode::demos {

/// The finished cells of an unfinished map, so that a killed run can be resumed: a text file whose first line
/// describes the map and whose other lines hold a cell each. Cells are appended in batches; an incomplete
/// line at the end is ignored, and its cell computed again. Only one run at a time can hold the journal.
class MapJournal {
 public:
  /// Opens the file, or creates it.
  /// @throws std::runtime_error that says what to do if the journal is that of another map, in use, or not
  /// writable
  MapJournal(const std::filesystem::path& file, const CellMap& map, bool restart);
  ~MapJournal();
  MapJournal(const MapJournal&) = delete;
  MapJournal& operator=(const MapJournal&) = delete;

  /// Returns the results that the file held when it was opened.
  const std::vector<CellResult>& finished() const { return finished_; }
  void append(const std::vector<CellResult>& results);
  /// Deletes the journal. Call this once the map is written.
  void remove();

 private:
  void open(bool restart);
  void read(const CellMap& map);
  void start_over(const std::string& header);
  void write(const std::string& text);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::size_t figure_count_;
  std::vector<CellResult> finished_;
};

}  // namespace polhode::demos
