// SQLite as this module uses it: what goes wrong is a Refusal.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace plumbline::batch {

class Database {
 public:
  /// Makes the file if there is none. Another process that writes is waited for, a minute at most. Refuses with
  /// batch-record.
  explicit Database(const std::string& path);

  /// Runs statements without results.
  void run(const char* sql);
  /// What `error` of SQLite means for whoever runs this, as a Refusal with batch-record.
  [[noreturn]] void refuse_error(int error) const;
  sqlite3* handle() const { return handle_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A statement, prepared once. Numbers of parameters count from 1, of columns from 0.
class Statement {
 public:
  /// `database` must outlive it.
  Statement(const Database& database, const char* sql);

  /// Texts must live until the next step() is done.
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::int64_t number);
  Statement& bind(int parameter, std::uint64_t number) { return bind(parameter, static_cast<std::int64_t>(number)); }
  /// True: there is a row. False: at the end, and it can be bound anew.
  bool step();
  /// Forgets the rows that are left.
  void reset();

  std::string text(int column) const;
  std::int64_t number(int column) const;
  std::uint64_t unsigned_number(int column) const { return static_cast<std::uint64_t>(number(column)); }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// What is written while one lives is written together, at commit(), or not at all.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

}  // namespace plumbline::batch
