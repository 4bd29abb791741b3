#include "identify/search/sqlite_database.h"

#include <sqlite3.h>

#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "analysis/files/output_folder.h"
#include "identify/search/findings.h"

namespace fourpost {
namespace {

/// Other programs write for a millisecond each.
constexpr int kPatience_ms = 60000;

const Finding& KindOf(int code) {
  switch (code) {
    case SQLITE_FULL: return kArchiveFull;
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT: return kArchiveDamaged;
    case SQLITE_BUSY: return kArchiveBusy;
    default: return kArchiveNotWritten;
  }
}

}  // namespace

Database::Database(std::filesystem::path file, int flags) : file_(std::move(file)) {
  const int code = sqlite3_open_v2(file_.c_str(), &handle_, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  if (code != SQLITE_OK) {
    const std::string reason = handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
    sqlite3_close(handle_);
    Throw(code, reason);
  }
  sqlite3_busy_timeout(handle_, kPatience_ms);
  // What a damaged or strange file says of triggers, views and pages is not believed.
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_exec(handle_, "PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
}

Database::~Database() { sqlite3_close_v2(handle_); }

void Database::Execute(const char* sql) const {
  constexpr int kPause_ms = 10;
  int code = sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr);
  for (int waited = 0; (code & 0xff) == SQLITE_BUSY && waited < kPatience_ms; waited += kPause_ms) {
    std::this_thread::sleep_for(std::chrono::milliseconds(kPause_ms));
    code = sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr);
  }
  Check(code);
}

void Database::Check(int code) const {
  if (code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE) Throw(code & 0xff, sqlite3_errmsg(handle_));
}

void Database::Throw(int code, const std::string& reason) const {
  throw OutputError(KindOf(code), {file_.string()}, {reason});
}

Statement::Statement(const Database& database, const char* sql) : database_(database) {
  database_.Check(sqlite3_prepare_v2(database_.handle(), sql, -1, &statement_, nullptr));
}

Statement::~Statement() { sqlite3_finalize(statement_); }

Statement& Statement::Bind(int place, std::int64_t number) {
  database_.Check(sqlite3_bind_int64(statement_, place, number));
  return *this;
}

Statement& Statement::Bind(int place, double number) {
  database_.Check(sqlite3_bind_double(statement_, place, number));
  return *this;
}

Statement& Statement::Bind(int place, std::string_view text) {
  database_.Check(sqlite3_bind_text(statement_, place, text.data(), static_cast<int>(text.size()), SQLITE_STATIC));
  return *this;
}

Statement& Statement::Bind(int place, const Eigen::VectorXd& numbers) {
  const auto size = static_cast<sqlite3_uint64>(numbers.size()) * sizeof(double);
  database_.Check(sqlite3_bind_blob64(statement_, place, numbers.data(), size, SQLITE_STATIC));
  return *this;
}

bool Statement::Step() {
  const int code = sqlite3_step(statement_);
  database_.Check(code);
  return code == SQLITE_ROW;
}

void Statement::Reset() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

std::int64_t Statement::Integer(int column) const { return sqlite3_column_int64(statement_, column); }

double Statement::Real(int column) const { return sqlite3_column_double(statement_, column); }

bool Statement::IsNull(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }

std::string Statement::Text(int column) const {
  const void* bytes = sqlite3_column_blob(statement_, column);
  return {static_cast<const char*>(bytes), static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

Eigen::VectorXd Statement::Numbers(int column) const {
  const void* bytes = sqlite3_column_blob(statement_, column);
  Eigen::VectorXd numbers(sqlite3_column_bytes(statement_, column) / static_cast<int>(sizeof(double)));
  if (numbers.size() > 0) std::memcpy(numbers.data(), bytes, static_cast<std::size_t>(numbers.size()) * sizeof(double));
  return numbers;
}

}  // namespace fourpost
