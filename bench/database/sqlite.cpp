#include "bench/database/sqlite.hpp"

#include "wend/io/text.hpp"

namespace wend {
namespace {

constexpr int kPatience = 10'000;  // milliseconds to wait while somebody else writes

}  // namespace

SqliteConnection::SqliteConnection(const std::filesystem::path& file) {
  sqlite3* database = nullptr;
  const int code =
      sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  database_.reset(database);
  check(code);
  if (ok()) sqlite3_busy_timeout(database_.get(), kPatience);
}

void SqliteConnection::fail(const std::string& what) {
  if (error_.empty()) error_ = what;
}

void SqliteConnection::check(int code) {
  if (code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE) return;
  // It may quote the schema, which is what the file says.
  constexpr std::size_t kLongest = 300;
  fail(text_line(database_ ? sqlite3_errmsg(database_.get()) : sqlite3_errstr(code), kLongest));
}

void SqliteConnection::run(const std::string& statements) {
  if (ok()) check(sqlite3_exec(database_.get(), statements.c_str(), nullptr, nullptr, nullptr));
}

SqliteStatement::SqliteStatement(SqliteConnection& connection, const std::string& text)
    : connection_(connection) {
  if (!connection_.ok()) return;
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(connection_.database_.get(), text.data(),
                                      static_cast<int>(text.size()), &statement, nullptr);
  statement_.reset(statement);
  connection_.check(code);
}

bool SqliteStatement::next() {
  if (!connection_.ok()) return false;
  const int code = sqlite3_step(statement_.get());
  connection_.check(code);
  return code == SQLITE_ROW;
}

bool SqliteStatement::has(int column) const {
  return sqlite3_column_type(statement_.get(), column) != SQLITE_NULL;
}

std::int64_t SqliteStatement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double SqliteStatement::number(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string SqliteStatement::text(int column) const {
  const auto* const text =
      reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text == nullptr ? std::string() : text;
}

// next() has already reported an error of the last run.
void SqliteStatement::reset() { sqlite3_reset(statement_.get()); }

void SqliteStatement::bind(int parameter, std::int64_t value) {
  if (connection_.ok()) connection_.check(sqlite3_bind_int64(statement_.get(), parameter, value));
}

void SqliteStatement::bind(int parameter, double value) {
  if (connection_.ok()) connection_.check(sqlite3_bind_double(statement_.get(), parameter, value));
}

void SqliteStatement::bind(int parameter, const std::optional<double>& value) {
  if (value) return bind(parameter, *value);
  if (connection_.ok()) connection_.check(sqlite3_bind_null(statement_.get(), parameter));
}

void SqliteStatement::bind(int parameter, const std::string& value) {
  if (!connection_.ok()) return;
  connection_.check(sqlite3_bind_text(statement_.get(), parameter, value.data(),
                                      static_cast<int>(value.size()), SQLITE_TRANSIENT));
}

SqliteTransaction::SqliteTransaction(SqliteConnection& connection)
    : connection_(connection), open_(connection.ok()) {
  connection_.run("BEGIN IMMEDIATE");
}

SqliteTransaction::~SqliteTransaction() {
  if (!open_ || connection_.database_ == nullptr) return;
  sqlite3_exec(connection_.database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void SqliteTransaction::commit() {
  connection_.run("COMMIT");
  if (connection_.ok()) open_ = false;
}

}  // namespace wend
