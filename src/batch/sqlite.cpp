#include "batch/sqlite.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include "base/diagnostic.hpp"

namespace plumbline::batch {
namespace {

constexpr int kPatience_ms = 60'000;

std::string_view way_out(int error) {
  switch (error & 0xFF) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another process has held it for a minute: wait until that is done, or give each a file of its own with "
             "--record";
    case SQLITE_NOTADB:
      return "it holds something else: name another file with --record";
    case SQLITE_CORRUPT:
      return "remove it: then all programs are compensated once more; or name another file with --record";
    default:
      return "check that its folder exists, may be written to and has room; --record puts it elsewhere";
  }
}

}  // namespace

void Database::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

Database::Database(const std::string& path) : path_(path) {
  sqlite3* handle = nullptr;
  const int error = sqlite3_open_v2(path.c_str(), &handle,
                                    SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_FULLMUTEX, nullptr);
  handle_.reset(handle);
  if (error != SQLITE_OK) refuse_error(error);
  sqlite3_busy_timeout(handle, kPatience_ms);
}

void Database::refuse_error(int error) const {
  Place place;
  place.file = path_;
  refuse("batch-record", fmt::format("the record of what was done cannot be used: {}", sqlite3_errmsg(handle_.get())),
         std::string(way_out(error)), place);
}

void Database::run(const char* sql) {
  const int error = sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr);
  if (error != SQLITE_OK) refuse_error(error);
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(const Database& database, const char* sql) : database_(database) {
  sqlite3_stmt* handle = nullptr;
  const int error = sqlite3_prepare_v3(database.handle(), sql, -1, SQLITE_PREPARE_PERSISTENT, &handle, nullptr);
  handle_.reset(handle);
  if (error != SQLITE_OK) database.refuse_error(error);
}

Statement& Statement::bind(int parameter, std::string_view text) {
  const int error =
      sqlite3_bind_text(handle_.get(), parameter, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
  if (error != SQLITE_OK) database_.refuse_error(error);
  return *this;
}

Statement& Statement::bind(int parameter, std::int64_t number) {
  const int error = sqlite3_bind_int64(handle_.get(), parameter, number);
  if (error != SQLITE_OK) database_.refuse_error(error);
  return *this;
}

bool Statement::step() {
  const int result = sqlite3_step(handle_.get());
  if (result == SQLITE_ROW) return true;
  sqlite3_reset(handle_.get());
  if (result != SQLITE_DONE) database_.refuse_error(result);
  return false;
}

void Statement::reset() { sqlite3_reset(handle_.get()); }

std::string Statement::text(int column) const {
  const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  return text == nullptr ? std::string()
                         : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column)));
}

std::int64_t Statement::number(int column) const { return sqlite3_column_int64(handle_.get(), column); }

Transaction::Transaction(Database& database) : database_(database) { database_.run("BEGIN IMMEDIATE"); }

Transaction::~Transaction() {
  if (is_open_) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.run("COMMIT");
  is_open_ = false;
}

}  // namespace plumbline::batch
