#include "identify/search/evaluation_store.h"

#include <sqlite3.h>

#include <bit>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "analysis/output_folder.h"
#include "analysis/sha256.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

/// Of this layout; another one gets another number.
constexpr int kLayout = 1;

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
  PRIMARY KEY (context, parameters));
PRAGMA user_version = 1;
)";

Failure FailureOf(std::string_view name) {
  for (int code = 0; FailureName(static_cast<Failure>(code)) != "unknown"; ++code)
    if (FailureName(static_cast<Failure>(code)) == name) return static_cast<Failure>(code);
  // Stored by another version, in whose context nobody looks for it.
  return Failure::kException;
}

std::string Remedy(int code) {
  switch (code) {
    case SQLITE_FULL: return "make room on the disk; what is there has been kept";
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT: return "it is no archive of evaluations, or damaged: move it away";
    case SQLITE_BUSY: return "another program holds it";
    default: return "allow writing, make room, or name another folder; what is there has been kept";
  }
}

/// A connection to SQLite whose errors are OutputErrors.
class Database {
 public:
  Database(fs::path file, int flags) : file_(std::move(file)) {
    const int code = sqlite3_open_v2(file_.c_str(), &handle_, flags | SQLITE_OPEN_NOMUTEX, nullptr);
    if (code != SQLITE_OK) {
      const std::string reason = handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
      sqlite3_close(handle_);
      Throw(code, reason);
    }
    sqlite3_busy_timeout(handle_, kPatience_ms);
  }
  ~Database() { sqlite3_close_v2(handle_); }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Tries again where SQLite gives up at once, as it does while another program opens the file.
  void Execute(const char* sql) const {
    constexpr int kPause_ms = 10;
    int code = sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr);
    for (int waited = 0; (code & 0xff) == SQLITE_BUSY && waited < kPatience_ms; waited += kPause_ms) {
      std::this_thread::sleep_for(std::chrono::milliseconds(kPause_ms));
      code = sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr);
    }
    Check(code);
  }

  void Check(int code) const {
    if (code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE) Throw(code & 0xff, sqlite3_errmsg(handle_));
  }

  [[noreturn]] void Throw(int code, const std::string& reason) const {
    throw OutputError(file_.string() + ": " + reason + "; " + Remedy(code));
  }

  sqlite3* handle() const { return handle_; }

 private:
  /// Other programs write for a millisecond each.
  static constexpr int kPatience_ms = 60000;

  fs::path file_;
  sqlite3* handle_ = nullptr;
};

/// A prepared statement. What is bound must live until the last Step().
class Statement {
 public:
  Statement(const Database& database, const char* sql) : database_(database) {
    database_.Check(sqlite3_prepare_v2(database_.handle(), sql, -1, &statement_, nullptr));
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& Bind(int place, std::int64_t number) {
    database_.Check(sqlite3_bind_int64(statement_, place, number));
    return *this;
  }
  Statement& Bind(int place, double number) {
    database_.Check(sqlite3_bind_double(statement_, place, number));
    return *this;
  }
  Statement& Bind(int place, std::string_view text) {
    database_.Check(sqlite3_bind_text(statement_, place, text.data(), static_cast<int>(text.size()), SQLITE_STATIC));
    return *this;
  }
  Statement& Bind(int place, const Eigen::VectorXd& numbers) {
    const auto size = static_cast<sqlite3_uint64>(numbers.size()) * sizeof(double);
    database_.Check(sqlite3_bind_blob64(statement_, place, numbers.data(), size, SQLITE_STATIC));
    return *this;
  }

  /// Whether there is a row.
  bool Step() {
    const int code = sqlite3_step(statement_);
    database_.Check(code);
    return code == SQLITE_ROW;
  }

  /// Lets go of the row, of the bound values and of the file.
  void Reset() {
    sqlite3_reset(statement_);
    sqlite3_clear_bindings(statement_);
  }

  std::int64_t Integer(int column) const { return sqlite3_column_int64(statement_, column); }
  double Real(int column) const { return sqlite3_column_double(statement_, column); }
  bool IsNull(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
  std::string Text(int column) const {
    const void* bytes = sqlite3_column_blob(statement_, column);
    return {static_cast<const char*>(bytes), static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
  }
  Eigen::VectorXd Numbers(int column) const {
    const void* bytes = sqlite3_column_blob(statement_, column);
    Eigen::VectorXd numbers(sqlite3_column_bytes(statement_, column) / static_cast<int>(sizeof(double)));
    if (numbers.size() > 0)
      std::memcpy(numbers.data(), bytes, static_cast<std::size_t>(numbers.size()) * sizeof(double));
    return numbers;
  }

 private:
  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// Resets a statement that is used again, whatever happens.
class Use {
 public:
  explicit Use(Statement& statement) : statement_(statement) {}
  ~Use() { statement_.Reset(); }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  Statement& statement_;
};

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

/// Makes the tables of a new file; other programs may be about to do the same.
void MakeTables(const Database& database) {
  database.Execute("BEGIN IMMEDIATE");
  if (IsEmpty(database)) database.Execute(kSchema);
  database.Execute("COMMIT");
}

void RequireLayout(const Database& database) {
  if (LayoutOf(database) != kLayout) database.Throw(SQLITE_NOTADB, "not the layout that this program knows");
}

/// Makes a file ready for use; leaves one that is not ours as it is.
const Database& Prepare(const Database& database) {
  if (!IsEmpty(database)) RequireLayout(database);
  database.Execute("PRAGMA journal_mode = WAL");
  // Flushes at checkpoints only: a killed program loses nothing by it.
  database.Execute("PRAGMA synchronous = NORMAL");
  if (IsEmpty(database)) MakeTables(database);
  RequireLayout(database);
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

/// Of the columns residuals, failure, detail and violation from `column` on.
Evaluation EvaluationAt(const Statement& row, int column) {
  if (row.IsNull(column + 1)) {
    Evaluation evaluation;
    evaluation.residuals = row.Numbers(column);
    return evaluation;
  }
  Evaluation evaluation = Failed(FailureOf(row.Text(column + 1)), row.Text(column + 2));
  evaluation.violation = row.Real(column + 3);
  return evaluation;
}

/// Nothing for a file that is not there or empty.
std::unique_ptr<Database> OpenToRead(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored) || fs::file_size(file, ignored) == 0) return nullptr;
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
             "SELECT residuals, failure, detail, violation FROM evaluation WHERE context = ?1 AND "
             "parameters = ?2"),
        put(database,
            "INSERT INTO evaluation (context, parameters, residuals, failure, detail, violation) "
            "VALUES (?1, ?2, ?3, ?4, ?5, ?6) ON CONFLICT DO UPDATE SET paid = paid + 1 RETURNING paid") {}

  Database database;
  Statement find;
  Statement put;
};

EvaluationStore::EvaluationStore(const fs::path& file, const EvaluationContext& context) : file_(file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error)
    throw OutputError(file.parent_path().string() + ": " + error.message() + "; allow it or name another folder");
  connection_ = std::make_unique<Connection>(file);
  context_ = UseContext(connection_->database, context);
}

EvaluationStore::~EvaluationStore() = default;

std::optional<Evaluation> EvaluationStore::Find(const Eigen::VectorXd& values) const {
  const std::lock_guard lock(mutex_);
  Statement& find = connection_->find;
  const Use use(find);
  find.Bind(1, context_).Bind(2, values);
  if (!find.Step()) return std::nullopt;
  return EvaluationAt(find, 0);
}

Evaluation EvaluationStore::Put(const Eigen::VectorXd& values, Evaluation evaluation) {
  {
    const std::lock_guard lock(mutex_);
    Statement& put = connection_->put;
    const Use use(put);
    put.Bind(1, context_).Bind(2, values);
    if (evaluation.ok()) {
      put.Bind(3, evaluation.residuals);
    } else {
      put.Bind(4, FailureName(evaluation.failure)).Bind(5, std::string_view(evaluation.detail));
      put.Bind(6, evaluation.violation);
    }
    put.Step();
    const bool first = put.Integer(0) == 1;
    // To the end, where SQLite commits.
    put.Step();
    if (first) return evaluation;
  }
  return *Find(values);
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

StoredContent ReadStoredContent(const fs::path& file) {
  StoredContent content;
  Sha256 digest;
  if (const std::unique_ptr<Database> database = OpenToRead(file)) {
    Statement rows(*database,
                   "SELECT residuals, failure, detail, violation, parameters, paid, vehicle, data, settings, version "
                   "FROM evaluation JOIN context ON context.id = evaluation.context "
                   "ORDER BY vehicle, data, settings, version, parameters");
    while (rows.Step()) {
      ++content.evaluations;
      content.paid += rows.Integer(5);
      for (const int column : {6, 7, 8, 9, 4, 0, 1, 2}) digest.Add(rows.Text(column));
      digest.Add(rows.Real(3));
    }
  }
  content.digest = digest.Hex();
  return content;
}

}  // namespace fourpost
