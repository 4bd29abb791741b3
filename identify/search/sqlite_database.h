#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <Eigen/Core>

struct sqlite3;
struct sqlite3_stmt;

namespace fourpost {

/// A connection to an SQLite file. Errors are thrown as OutputErrors that name the file and what to do.
class Database {
 public:
  /// `flags`: SQLITE_OPEN_... For one thread at a time.
  Database(std::filesystem::path file, int flags);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Tries again where SQLite gives up at once, as it does while another program opens the file.
  void Execute(const char* sql) const;

  /// Throws for a result code that is an error.
  void Check(int code) const;

  [[noreturn]] void Throw(int code, const std::string& reason) const;

  sqlite3* handle() const { return handle_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

/// A prepared statement. What is bound must live until the last Step(); places count from 1, columns from 0.
class Statement {
 public:
  Statement(const Database& database, const char* sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& Bind(int place, std::int64_t number);
  Statement& Bind(int place, double number);
  Statement& Bind(int place, std::string_view text);
  /// Their bytes.
  Statement& Bind(int place, const Eigen::VectorXd& numbers);

  /// Whether there is a row.
  bool Step();

  /// Lets go of the row, of the bound values and of the file.
  void Reset();

  std::int64_t Integer(int column) const;
  double Real(int column) const;
  bool IsNull(int column) const;
  std::string Text(int column) const;
  Eigen::VectorXd Numbers(int column) const;

 private:
  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// Resets a statement that is used again, whatever happens.
class StatementUse {
 public:
  explicit StatementUse(Statement& statement) : statement_(statement) {}
  ~StatementUse() { statement_.Reset(); }
  StatementUse(const StatementUse&) = delete;
  StatementUse& operator=(const StatementUse&) = delete;

 private:
  Statement& statement_;
};

}  // namespace fourpost
