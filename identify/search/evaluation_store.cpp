#include "identify/search/evaluation_store.h"

#include <sqlite3.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string_view>
#include <utility>

#include "analysis/files/output_folder.h"
#include "analysis/files/sha256.h"
#include "analysis/files/text_file.h"

#include "identify/search/findings.h"
#include "identify/search/sqlite_database.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

/// Where every SQLite file says whose it is, 68 bytes from its start (SQLite Database File Format, section 1.3).
constexpr std::string_view kApplication = "4pst";
constexpr std::size_t kApplicationAt = 68;

/// Of this layout; another one gets another number. Layout 1, of version 0.1.0, had no checksums.
constexpr int kLayout = 2;

// Values and residuals are bytes of doubles as the processor keeps them.
static_assert(std::endian::native == std::endian::little);

constexpr const char* kSchema = R"(
CREATE TABLE context (
  id INTEGER PRIMARY KEY,
  vehicle TEXT NOT NULL, data TEXT NOT NULL, settings TEXT NOT NULL, version TEXT NOT NULL,
  -- The greatest is that of the context used last.
  use INTEGER NOT NULL,
  UNIQUE (vehicle, data, settings, version));
CREATE TABLE evaluation (
  context INTEGER NOT NULL REFERENCES context,
  parameters BLOB NOT NULL,
  residuals BLOB,
  -- Of a failure, which has no residuals.
  failure TEXT, detail TEXT, violation REAL,
  paid INTEGER NOT NULL DEFAULT 1,
  -- Of context, parameters and what came of them, each with its length.
  checksum TEXT,
  PRIMARY KEY (context, parameters));
-- The bytes 4pst.
PRAGMA application_id = 0x34707374;
PRAGMA user_version = 2;
)";

/// Evaluations without a checksum stay; they belong to another build of fourpost and are not asked for.
constexpr const char* kFromLayout1 = "ALTER TABLE evaluation ADD COLUMN checksum TEXT; PRAGMA user_version = 2";

Failure FailureOf(std::string_view name) {
  for (int code = 0; FailureName(static_cast<Failure>(code)) != "unknown"; ++code)
    if (FailureName(static_cast<Failure>(code)) == name) return static_cast<Failure>(code);
  // Stored by another version, in whose context nobody looks for it.
  return Failure::kException;
}

/// Throws for the file of another program. Not by SQLite, which takes in the log of whatever it opens.
void RequireOurs(const fs::path& file) {
  if (WhyNoFile(file)) throw OutputError(kArchiveNotFile, {file.string()});
  std::string head(kApplicationAt + kApplication.size(), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  // A new one, or one that cannot be read at all, which SQLite explains.
  if (stream.gcount() == 0) return;
  if (!head.starts_with("SQLite format 3") || !head.ends_with(kApplication))
    throw OutputError(kArchiveForeign, {file.string()});
}

int LayoutOf(const Database& database) {
  Statement statement(database, "PRAGMA user_version");
  statement.Step();
  return static_cast<int>(statement.Integer(0));
}

bool IsEmpty(const Database& database) {
  Statement statement(database, "SELECT count(*) FROM sqlite_schema");
  statement.Step();
  return statement.Integer(0) == 0;
}

/// Makes the tables of a new file; other programs may be about to do the same. Before there is a log, so that the file
/// itself shows whose it is from its first byte on.
void MakeTables(const Database& database) {
  database.Execute("BEGIN IMMEDIATE");
  if (IsEmpty(database)) database.Execute(kSchema);
  database.Execute("COMMIT");
}

/// Throws for layouts that came later than this program; those before are read.
void RequireLayout(const Database& database) {
  const int layout = LayoutOf(database);
  if (layout < 1 || layout > kLayout)
    throw OutputError(kArchiveLayout, {database.file().string()}, {std::to_string(layout), std::to_string(kLayout)});
}

/// Other programs may be about to do the same.
void AddChecksums(const Database& database) {
  database.Execute("BEGIN IMMEDIATE");
  if (LayoutOf(database) == 1) database.Execute(kFromLayout1);
  database.Execute("COMMIT");
}

/// Makes a file ready for use.
const Database& Prepare(const Database& database) {
  if (IsEmpty(database)) MakeTables(database);
  RequireLayout(database);
  if (LayoutOf(database) == 1) AddChecksums(database);
  database.Execute("PRAGMA journal_mode = WAL");
  // Flushes at checkpoints only: a killed program loses nothing by it.
  database.Execute("PRAGMA synchronous = NORMAL");
  return database;
}

void BindContext(Statement& statement, const EvaluationContext& context) {
  statement.Bind(1, std::string_view(context.vehicle)).Bind(2, std::string_view(context.data));
  statement.Bind(3, std::string_view(context.settings)).Bind(4, std::string_view(context.version));
}

/// The number of the context in the file, used last from now on.
std::int64_t UseContext(const Database& database, const EvaluationContext& context) {
  Statement statement(database,
                      "INSERT INTO context (vehicle, data, settings, version, use) "
                      "VALUES (?1, ?2, ?3, ?4, (SELECT ifnull(max(use), 0) + 1 FROM context)) "
                      "ON CONFLICT DO UPDATE SET use = excluded.use RETURNING id");
  BindContext(statement, context);
  statement.Step();
  const std::int64_t id = statement.Integer(0);
  statement.Step();
  return id;
}

std::string_view ViewOf(const Eigen::VectorXd& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), static_cast<std::size_t>(numbers.size()) * sizeof(double)};
}

/// What stands in the row of these values when nobody changed it.
std::string ChecksumOf(const EvaluationContext& context, const Eigen::VectorXd& values, const Evaluation& evaluation) {
  Sha256 sum;
  for (const std::string* part : {&context.vehicle, &context.data, &context.settings, &context.version})
    sum.Add(std::string_view(*part));
  sum.Add(ViewOf(values));
  sum.Add(evaluation.ok() ? std::string_view() : FailureName(evaluation.failure));
  sum.Add(evaluation.ok() ? ViewOf(evaluation.residuals) : std::string_view(evaluation.detail));
  sum.Add(evaluation.ok() ? 0.0 : evaluation.violation);
  return sum.Hex();
}

/// Of the columns residuals, failure, detail and violation.
Evaluation EvaluationOf(const Statement& row) {
  if (row.IsNull(1)) {
    Evaluation evaluation;
    evaluation.residuals = row.Numbers(0);
    return evaluation;
  }
  Evaluation evaluation = Failed(FailureOf(row.Text(1)), row.Text(2));
  evaluation.violation = row.Real(3);
  return evaluation;
}

/// Nothing for a file that is not there or empty.
std::unique_ptr<Database> OpenToRead(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored) || fs::file_size(file, ignored) == 0) return nullptr;
  RequireOurs(file);
  // A log that a killed program left behind is taken in, for which even readers write.
  auto database = std::make_unique<Database>(file, SQLITE_OPEN_READWRITE);
  if (IsEmpty(*database)) return nullptr;
  RequireLayout(*database);
  return database;
}

}  // namespace

struct EvaluationStore::Connection {
  explicit Connection(const fs::path& file)
      : database(file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE),
        find(Prepare(database),
             "SELECT residuals, failure, detail, violation, checksum FROM evaluation WHERE context = ?1 AND "
             "parameters = ?2"),
        put(database, (kInsert + " ON CONFLICT DO UPDATE SET paid = paid + 1 RETURNING paid").c_str()),
        replace(database, (kInsert + " ON CONFLICT DO UPDATE SET residuals = excluded.residuals, "
                                     "failure = excluded.failure, detail = excluded.detail, "
                                     "violation = excluded.violation, checksum = excluded.checksum, paid = 1 "
                                     "RETURNING paid")
                              .c_str()) {}

  inline static const std::string kInsert =
      "INSERT INTO evaluation (context, parameters, residuals, failure, detail, violation, checksum) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)";

  Database database;
  Statement find;
  Statement put;
  Statement replace;
};

EvaluationStore::EvaluationStore(const fs::path& file, const EvaluationContext& context)
    : file_(file), parts_(context) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throw OutputError(kArchiveFolder, {file.parent_path().string()}, {error.message()});
  RequireOurs(file);
  connection_ = std::make_unique<Connection>(file);
  context_ = UseContext(connection_->database, context);
}

EvaluationStore::~EvaluationStore() = default;

/// While it lives no other thread has these values.
class EvaluationStore::Claim {
 public:
  Claim(EvaluationStore& store, const Eigen::VectorXd& values) : store_(store), bytes_(BytesOf(values)) {
    std::unique_lock lock(store_.claims_mutex_);
    store_.released_.wait(lock, [&] { return store_.claimed_.insert(bytes_).second; });
  }
  ~Claim() {
    {
      const std::lock_guard lock(store_.claims_mutex_);
      store_.claimed_.erase(bytes_);
    }
    store_.released_.notify_all();
  }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

 private:
  EvaluationStore& store_;
  std::string bytes_;
};

EvaluationStore::Answer EvaluationStore::FindOrEvaluate(const Eigen::VectorXd& values,
                                                        const std::function<Evaluation()>& evaluate) {
  const Claim claim(*this, values);
  if (std::optional<Evaluation> stored = Find(values)) return {*std::move(stored), true};
  return {Put(values, evaluate()), false};
}

std::optional<Evaluation> EvaluationStore::Find(const Eigen::VectorXd& values) const {
  const std::lock_guard lock(mutex_);
  Statement& find = connection_->find;
  const StatementUse use(find);
  find.Bind(1, context_).Bind(2, values);
  if (!find.Step()) return std::nullopt;
  Evaluation evaluation = EvaluationOf(find);
  if (find.Text(4) == ChecksumOf(parts_, values, evaluation)) return evaluation;
  damaged_.insert(BytesOf(values));
  return std::nullopt;
}

bool EvaluationStore::Insert(const Eigen::VectorXd& values, const Evaluation& evaluation, bool replace) {
  const std::string checksum = ChecksumOf(parts_, values, evaluation);
  const std::lock_guard lock(mutex_);
  Statement& put = replace ? connection_->replace : connection_->put;
  const StatementUse use(put);
  put.Bind(1, context_).Bind(2, values);
  if (evaluation.ok()) {
    put.Bind(3, evaluation.residuals);
  } else {
    put.Bind(4, FailureName(evaluation.failure)).Bind(5, std::string_view(evaluation.detail));
    put.Bind(6, evaluation.violation);
  }
  put.Bind(7, std::string_view(checksum));
  put.Step();
  const bool first = put.Integer(0) == 1;
  // To the end, where SQLite commits.
  put.Step();
  return first;
}

Evaluation EvaluationStore::Put(const Eigen::VectorXd& values, Evaluation evaluation) {
  if (Insert(values, evaluation, false)) return evaluation;
  if (std::optional<Evaluation> stored = Find(values)) return *std::move(stored);
  Insert(values, evaluation, true);
  return evaluation;
}

std::size_t EvaluationStore::damaged() const {
  const std::lock_guard lock(mutex_);
  return damaged_.size();
}

std::vector<std::string> ChangedParts(const fs::path& file, const EvaluationContext& context) {
  const std::unique_ptr<Database> database = OpenToRead(file);
  if (!database) return {};
  Statement rows(*database, "SELECT vehicle, data, settings, version FROM context ORDER BY use DESC");
  std::vector<std::string> changed;
  for (bool is_last = true; rows.Step(); is_last = false) {
    const EvaluationContext stored = {rows.Text(0), rows.Text(1), rows.Text(2), rows.Text(3)};
    if (stored == context) return {};
    if (!is_last) continue;
    if (stored.vehicle != context.vehicle) changed.emplace_back("vehicle");
    if (stored.data != context.data) changed.emplace_back("data");
    if (stored.settings != context.settings) changed.emplace_back("settings");
    if (stored.version != context.version) changed.emplace_back("version");
  }
  return changed;
}

namespace {

/// Evaluations that a row stands for, by its values' bytes: one for each parameter where it is a Jacobian's.
std::int64_t WorthOf(std::string_view bytes) {
  double last = 0;
  if (bytes.size() < sizeof last) return 1;
  std::memcpy(&last, bytes.data() + bytes.size() - sizeof last, sizeof last);
  return std::isnan(last) ? static_cast<std::int64_t>(bytes.size() / sizeof last) - 1 : 1;
}

}  // namespace

StoredContent ReadStoredContent(const fs::path& file) {
  StoredContent content;
  Sha256 digest;
  if (const std::unique_ptr<Database> database = OpenToRead(file)) {
    Statement rows(*database,
                   "SELECT residuals, failure, detail, violation, parameters, paid, vehicle, data, settings, version "
                   "FROM evaluation JOIN context ON context.id = evaluation.context "
                   "ORDER BY vehicle, data, settings, version, parameters");
    while (rows.Step()) {
      const std::int64_t worth = WorthOf(rows.Text(4));
      content.evaluations += worth;
      content.paid += worth * rows.Integer(5);
      for (const int column : {6, 7, 8, 9, 4, 0, 1, 2}) digest.Add(rows.Text(column));
      digest.Add(rows.Real(3));
    }
  }
  content.digest = digest.Hex();
  return content;
}

}  // namespace fourpost
