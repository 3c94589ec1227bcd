#pragma once

// A look into a database, without any code of ours.

#include <sqlite3.h>

#include <string>

namespace wend::test {

/// The only number that a query finds; -1 where the database is not there or is in use.
inline int number_in(const std::string& file, const std::string& query) {
  sqlite3* database = nullptr;
  int number = -1;
  const auto keep = [](void* out, int /*columns*/, char** fields, char** /*names*/) {
    *static_cast<int*>(out) = std::stoi(fields[0]);
    return 0;
  };
  if (sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr) == SQLITE_OK) {
    sqlite3_exec(database, query.c_str(), keep, &number, nullptr);
  }
  sqlite3_close(database);
  return number;
}

}  // namespace wend::test
