#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include <Eigen/Core>

#include "identify/search/evaluation.h"

namespace fourpost {

/// Everything but the parameter values that an evaluation depends on: a digest of each part.
struct EvaluationContext {
  std::string vehicle;
  std::string data;
  std::string settings;
  std::string version;

  bool operator==(const EvaluationContext&) const = default;
};

/// Evaluations kept in a file (SQLite, WAL), failures as well: whoever evaluates the same values in the same context,
/// in this run or another, gets what was stored, to the last bit. Each is in the file before Put() returns, so that a
/// killed program has lost none that it used; only a loss of power may take the last ones. Each carries a checksum: one
/// that was changed on the disk is treated as missing, and is counted. Other contexts in the file stay and are not
/// used. May be used from several threads, and the file by several programs at once.
class EvaluationStore {
 public:
  /// Opens the file, or creates it. Throws OutputError when that is not possible, or when it is no such file, which
  /// then stays as it is.
  EvaluationStore(const std::filesystem::path& file, const EvaluationContext& context);
  ~EvaluationStore();
  EvaluationStore(const EvaluationStore&) = delete;
  EvaluationStore& operator=(const EvaluationStore&) = delete;

  const std::filesystem::path& file() const { return file_; }

  /// Of these values, compared bit by bit; nothing where what is stored is damaged. Throws OutputError when the file
  /// cannot be read.
  std::optional<Evaluation> Find(const Eigen::VectorXd& values) const;

  struct Answer {
    Evaluation evaluation;
    /// Before it was asked for, or by another thread meanwhile.
    bool was_stored = false;
  };

  /// What is stored of these values, or else what `evaluate` makes of them, which is stored before anything is made of
  /// it. Of threads that ask for the same at once one evaluates and the others wait, so `evaluate` must not ask in
  /// turn. Throws what `evaluate`, Find() and Put() throw.
  Answer FindOrEvaluate(const Eigen::VectorXd& values, const std::function<Evaluation()>& evaluate);

  /// Stores it, and returns what is stored: where another program was faster, its evaluation. Throws OutputError when
  /// it cannot be written, as on a full disk; what was there before stays.
  Evaluation Put(const Eigen::VectorXd& values, Evaluation evaluation);

  /// Evaluations that were asked for and whose stored bytes are not those of their checksum.
  std::size_t damaged() const;

 private:
  struct Connection;
  class Claim;
  /// False where another program was faster.
  bool Insert(const Eigen::VectorXd& values, const Evaluation& evaluation, bool replace);

  std::filesystem::path file_;
  EvaluationContext parts_;
  std::unique_ptr<Connection> connection_;
  std::int64_t context_ = 0;
  mutable std::mutex mutex_;
  // The bytes of their values.
  mutable std::unordered_set<std::string> damaged_;
  // The bytes of the values that a thread evaluates.
  std::unordered_set<std::string> claimed_;
  std::mutex claims_mutex_;
  std::condition_variable released_;
};

/// The parts in which this context differs from the one that the file was used with last: "vehicle", "data",
/// "settings", "version"; none when the file holds this context, or none, or is not there. Throws OutputError as
/// EvaluationStore does.
std::vector<std::string> ChangedParts(const std::filesystem::path& file, const EvaluationContext& context);

/// All that a file holds, over all contexts.
struct StoredContent {
  /// A Jacobian, stored under its point's values and NaN, counts as one for each parameter, as in EvaluationCounts.
  std::int64_t evaluations = 0;
  /// How often one of them was evaluated; above `evaluations` where programs that ran at once evaluated the same.
  std::int64_t paid = 0;
  /// Of contexts, values and what came of them, in the order of their keys: the same for the same content, whenever and
  /// in whichever order it was stored.
  std::string digest;
};

/// Throws OutputError as EvaluationStore does.
StoredContent ReadStoredContent(const std::filesystem::path& file);

}  // namespace fourpost
