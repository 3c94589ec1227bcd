#pragma once

// An SQLite database for the sources of this module: other headers need no SQLite.
//
// The first error is kept: later calls do nothing, and error() returns it. So a function checks once, at
// its end.

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace wend {

class SqliteConnection {
 public:
  /// Opens a file; creates it if it does not exist.
  explicit SqliteConnection(const std::filesystem::path& file);

  bool ok() const { return error_.empty(); }

  /// The error message; empty if there was no error.
  const std::string& error() const { return error_; }

  /// Keeps an error, unless there is one already.
  void fail(const std::string& what);

  /// Runs statements that return no rows.
  void run(const std::string& statements);

 private:
  friend class SqliteStatement;
  friend class SqliteTransaction;
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
  };

  void check(int code);

  std::unique_ptr<sqlite3, Close> database_;
  std::string error_;
};

/// A statement with parameters that can be run repeatedly.
///
///   SqliteStatement query(connection, "SELECT name FROM planners WHERE id = ?");
///   for (query.start(std::int64_t{7}); query.next();) names.push_back(query.text(0));
class SqliteStatement {
 public:
  SqliteStatement(SqliteConnection& connection, const std::string& text);

  /// Resets the statement and binds a value to each parameter, in order.
  template <class... Values>
  void start(const Values&... values) {
    reset();
    bind_all(std::index_sequence_for<Values...>(), values...);
  }

  /// Goes to the next row; false after the last one and after an error.
  bool next();

  /// Starts the statement and goes to its first row, for statements with at most one row of interest.
  template <class... Values>
  bool run(const Values&... values) {
    start(values...);
    return next();
  }

  /// The values of the row, by column from 0.
  bool has(int column) const;  // false for NULL
  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string text(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };

  template <std::size_t... kIndex, class... Values>
  void bind_all(std::index_sequence<kIndex...> /*indices*/, const Values&... values) {
    (bind(static_cast<int>(kIndex) + 1, values), ...);
  }

  void reset();
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, double value);
  void bind(int parameter, const std::optional<double>& value);  // nothing: NULL
  void bind(int parameter, const std::string& value);

  SqliteConnection& connection_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// A transaction: without commit(), the destructor rolls everything back.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(SqliteConnection& connection);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  void commit();

 private:
  SqliteConnection& connection_;
  bool open_;
};

}  // namespace wend
