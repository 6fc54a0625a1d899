#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workprecision/cell_map.h"

namespace polhode::demos {

/// The finished cells of a map under way, so that a killed run can be continued: a text file, whose first
/// line describes the map and each other a cell. Cells are appended in batches; what a kill has torn at the
/// end is computed again. Only one run at a time may hold it.
class MapJournal {
 public:
  /// Goes on with the file if it is there, or starts it.
  /// @throws std::runtime_error that says what to do: it is another map's, in use, or cannot be written.
  MapJournal(const std::filesystem::path& file, const CellMap& map, bool restart);
  ~MapJournal();
  MapJournal(const MapJournal&) = delete;
  MapJournal& operator=(const MapJournal&) = delete;

  /// Returns the results that the file held when it was opened.
  const std::vector<CellResult>& finished() const { return finished_; }
  void append(const std::vector<CellResult>& results);
  /// Once the map itself is written.
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
