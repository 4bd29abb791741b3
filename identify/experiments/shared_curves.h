#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/experiments/run_folder.h"
#include "identify/experiments/run_history.h"

namespace fourpost {

/// Of a run, by its number.
template <typename Item>
struct OfRun {
  std::size_t run = 0;
  const Item* item = nullptr;
};

/// What several runs have alike: the first decides what was measured.
template <typename Item>
using Shared = std::vector<OfRun<Item>>;

/// Items that are the same by `is_same`, in the order in which they come; those of one run alone left out.
template <typename Item, typename IsSame>
std::vector<Shared<Item>> SharedOf(const std::vector<std::vector<Item>>& of_runs, const IsSame& is_same) {
  std::vector<Shared<Item>> all;
  for (std::size_t run = 0; run < of_runs.size(); ++run)
    for (const Item& item : of_runs[run]) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Shared<Item>& shared) {
        return shared.back().run != run && is_same(*shared.front().item, item);
      });
      if (found == all.end()) all.push_back({{run, &item}});
      else found->push_back({run, &item});
    }
  std::erase_if(all, [](const Shared<Item>& shared) { return shared.size() < 2; });
  return all;
}

/// Of numbers of files, which write all digits; of another version, perhaps fewer.
bool AreAlike(const std::vector<double>& a, const std::vector<double>& b);

/// A channel over time, of a table.
struct TimedChannel {
  const TimeTable* table = nullptr;
  std::string name;
  const TableColumn* time = nullptr;
  const TableColumn* measured = nullptr;
  const TableColumn* modelled = nullptr;
};

/// Where the table has all of these columns.
void AddChannel(const TimeTable& table, const std::string& name, const std::string& time, const std::string& measured,
                const std::string& modelled, std::vector<TimedChannel>& channels);

/// What is known of a shared channel beside its lines, of the rows that are shown.
using DescribeChannel =
    std::function<nlohmann::ordered_json(const TimedChannel& first, const std::set<std::size_t>& rows)>;

/// A line per run of each channel that two runs or more have alike, thinned alike in all of them. `of_runs`: of each
/// of `runs`.
nlohmann::ordered_json SharedOverTime(const std::vector<std::vector<TimedChannel>>& of_runs,
                                      std::span<const RunFolder> runs, const DescribeChannel& describe);

}  // namespace fourpost
