#include "workprecision/map.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "command_line/interruption.h"
#include "command_line/program.h"
#include "command_line/progress_bar.h"
#include "workprecision/cell_workers.h"
#include "workprecision/map_journal.h"
#include "workprecision/output_files.h"

namespace polhode::demos {

namespace {

namespace fs = std::filesystem;

// Ranks exchange bytes, which requires machines of the same kind.
template <class Item>
std::string to_bytes(const std::vector<Item>& items) {
  static_assert(std::is_trivially_copyable_v<Item>, "sent byte by byte");
  return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item)};
}

template <class Item>
std::vector<Item> from_bytes(const std::string& bytes) {
  std::vector<Item> items(bytes.size() / sizeof(Item));
  if (!items.empty()) std::memcpy(items.data(), bytes.data(), bytes.size());
  return items;
}

fs::path journal_path(const Outputs& outputs) {
  fs::path path = outputs.csv ? *outputs.csv : outputs.json.value();
  path += ".partial";
  return path;
}

/// The journal and the results so far, held by rank 0 only.
class MapRecord {
 public:
  MapRecord(const CellMap& map, const MapRun& run)
      : map_(map), outputs_(run.outputs), results_(static_cast<std::size_t>(map.cell_count())) {
    const OutputFiles can_be_written(outputs_.csv, outputs_.json);
    journal_.emplace(journal_path(outputs_), map, run.restart);
    for (const CellResult& result : journal_->finished()) keep(result);
  }

  std::vector<std::int64_t> cells_to_do() const {
    std::vector<std::int64_t> cells;
    for (std::size_t i = 0; i < results_.size(); ++i) {
      if (!results_[i]) cells.push_back(static_cast<std::int64_t>(i));
    }
    return cells;
  }

  void add(const std::vector<std::string>& from_ranks) {
    for (const std::string& bytes : from_ranks) {
      const std::vector<CellResult> results = from_bytes<CellResult>(bytes);
      journal_->append(results);
      for (const CellResult& result : results) keep(result);
    }
  }

  std::int64_t done() const { return done_; }

  void finish() {
    std::vector<CellResult> results;
    results.reserve(results_.size());
    for (const std::optional<CellResult>& result : results_) results.push_back(result.value());
    OutputFiles files(outputs_.csv, outputs_.json);
    files.write(map_.csv(results), map_.json(results));
    journal_->remove();
    print(map_.summary(results));
  }

 private:
  void keep(const CellResult& result) {
    std::optional<CellResult>& place = results_[static_cast<std::size_t>(result.index)];
    if (!place) ++done_;
    place = result;
  }

  const CellMap& map_;
  const Outputs& outputs_;
  std::optional<MapJournal> journal_;
  std::vector<std::optional<CellResult>> results_;
  std::int64_t done_ = 0;
};

std::vector<std::int64_t> part_of(const std::vector<std::int64_t>& cells, std::size_t begin,
                                  std::size_t size) {
  const std::size_t from = std::min(begin, cells.size());
  const std::size_t to = std::min(begin + size, cells.size());
  return {cells.begin() + static_cast<std::ptrdiff_t>(from), cells.begin() + static_cast<std::ptrdiff_t>(to)};
}

void compute_all(const CellMap& map, const MapRun& run, Ranks& ranks, std::optional<MapRecord>& record) {
  std::string bytes;
  if (record) bytes = to_bytes(record->cells_to_do());
  const std::vector<std::int64_t> cells = from_bytes<std::int64_t>(ranks.broadcast(bytes));
  const std::size_t threads = thread_count(run.threads, ranks.count());
  // Rounds are short, so that a kill costs little and one slow rank does not delay the others for long. All
  // ranks use the same size, since they must go through the same rounds.
  const std::size_t wish = threads * static_cast<std::size_t>(map.cells_in_round());
  const std::size_t size =
      from_bytes<std::size_t>(ranks.broadcast(to_bytes(std::vector<std::size_t>{wish})))[0];
  std::optional<ProgressBar> progress;
  if (record) progress.emplace(map.cell_count());
  const std::size_t all_ranks = static_cast<std::size_t>(ranks.count());
  for (std::size_t begin = 0; begin < cells.size(); begin += size * all_ranks) {
    std::string own;
    ranks.together([&] {
      const std::size_t own_begin = begin + size * static_cast<std::size_t>(ranks.rank());
      own = to_bytes(computed_by_threads(map, part_of(cells, own_begin, size), threads));
    });
    const std::vector<std::string> from_ranks = ranks.gather(own);
    ranks.together([&] {
      if (!record) return;
      record->add(from_ranks);
      progress->show(record->done(), "cells");
    });
  }
}

}  // namespace

void make_map(const CellMap& map, const MapRun& run, Ranks& ranks) {
  const std::string first_ranks = ranks.broadcast(map.description());
  std::optional<MapRecord> record;
  ranks.together([&] {
    if (map.description() != first_ranks) {
      throw std::runtime_error(
          "the ranks have different options or programs; valid are the same ones on all ranks");
    }
    if (ranks.is_first()) record.emplace(map, run);
  });
  try {
    compute_all(map, run, ranks, record);
  } catch (const Interrupted& interrupted) {
    throw Interrupted(interrupted.signal(), "interrupted; the finished cells are in \"" +
                                                journal_path(run.outputs).string() +
                                                "\", from which the same command resumes");
  }
  ranks.together([&] {
    if (record) record->finish();
  });
}

}  // namespace polhode::demos
