#include "batch/record.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/diagnostic.hpp"
#include "base/text/hash.hpp"

namespace plumbline::batch {
namespace {

using Json = nlohmann::json;

constexpr int kForm = 1;

constexpr const char* kTable =
    "CREATE TABLE IF NOT EXISTS outputs (place TEXT PRIMARY KEY, source TEXT, program_size INTEGER, "
    "program_changed_ns INTEGER, program_number INTEGER, program_hash INTEGER, settings INTEGER, dialect TEXT, "
    "called TEXT, folder_changed_ns INTEGER, output_size INTEGER, output_changed_ns INTEGER, output_number INTEGER, "
    "output_hash INTEGER, has_undo INTEGER, summary TEXT) WITHOUT ROWID";
constexpr const char* kFind = "SELECT * FROM outputs WHERE place = ?1";
constexpr const char* kEach =
    "SELECT place, source, program_size, program_changed_ns, program_number, program_hash, settings, dialect, called, "
    "folder_changed_ns, output_size, output_changed_ns, output_number, output_hash, has_undo, '' FROM outputs";
constexpr const char* kPut =
    "INSERT OR REPLACE INTO outputs VALUES (?1,?2,?3,?4,?5,?6,?7,?8,?9,?10,?11,?12,?13,?14,?15,?16)";
constexpr const char* kRemove = "DELETE FROM outputs WHERE place = ?1";

// Names of files may be no UTF-8: they are kept byte for byte as Latin-1 would read them.
std::string as_utf8(std::string_view bytes) {
  std::string out;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xC0U | (byte >> 6U));
      out += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return out;
}

std::string as_bytes(const std::string& utf8) {
  std::string out;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte < 0x80 || i + 1 == utf8.size()) {
      out += utf8[i];
    } else {
      out += static_cast<char>((byte << 6U) | (static_cast<unsigned char>(utf8[++i]) & 0x3FU));
    }
  }
  return out;
}

std::string called_text(const std::vector<CalledFile>& called) {
  if (called.empty()) return {};
  Json json = Json::array();
  for (const CalledFile& one : called) {
    json.push_back({as_utf8(one.name), as_utf8(one.path), one.file.state.size, one.file.state.changed_ns,
                    one.file.state.number, one.file.hash});
  }
  return json.dump();
}

std::vector<CalledFile> called_in(const std::string& text) {
  std::vector<CalledFile> called;
  if (text.empty()) return called;
  for (const Json& one : Json::parse(text)) {
    called.push_back({as_bytes(one.at(0).get<std::string>()),
                      as_bytes(one.at(1).get<std::string>()),
                      {{one.at(2).get<std::uint64_t>(), one.at(3).get<std::int64_t>(), one.at(4).get<std::uint64_t>()},
                       one.at(5).get<std::uint64_t>()}});
  }
  return called;
}

KnownFile file_at(const Statement& row, int column) {
  return {{row.unsigned_number(column), row.number(column + 1), row.unsigned_number(column + 2)},
          row.unsigned_number(column + 3)};
}

void bind_file(Statement& statement, int parameter, const KnownFile& file) {
  statement.bind(parameter, file.state.size).bind(parameter + 1, file.state.changed_ns);
  statement.bind(parameter + 2, file.state.number).bind(parameter + 3, file.hash);
}

Entry entry_at(const Statement& row) {
  return {row.text(0),         row.text(1),
          file_at(row, 2),     row.unsigned_number(6),
          row.text(7),         called_in(row.text(8)),
          row.number(9),       file_at(row, 10),
          row.number(14) != 0, row.text(15)};
}

}  // namespace

Database Record::prepared(const std::string& path) {
  Database database(path);
  // A rollback journal works on file systems of other machines as well, as far as those lock files; WAL does not.
  // It goes with the end of each transaction: the record is one file.
  database.run("PRAGMA journal_mode = DELETE");
  Transaction transaction(database);
  Statement form(database, "PRAGMA user_version");
  form.step();
  const std::int64_t found = form.number(0);
  form.reset();
  if (found > kForm) {
    Place place;
    place.file = path;
    refuse("batch-record", "the record of what was done is one of a later version of plumbline",
           "use that version, or name another file with --record", place);
  }
  database.run(kTable);
  database.run(fmt::format("PRAGMA user_version = {}", kForm).c_str());
  transaction.commit();
  return database;
}

Record::Record(const std::string& path)
    : database_(prepared(path)), find_(database_, kFind), put_(database_, kPut), remove_(database_, kRemove) {}

std::optional<Entry> Record::find(const std::string& place) {
  const std::scoped_lock lock(guard_);
  find_.bind(1, place);
  if (!find_.step()) return std::nullopt;
  Entry entry = entry_at(find_);
  find_.reset();
  return entry;
}

void Record::put(const std::vector<const Entry*>& entries) {
  if (entries.empty()) return;
  const std::scoped_lock lock(guard_);
  Transaction transaction(database_);
  for (const Entry* const entry : entries) {
    const std::string called = called_text(entry->called);
    put_.bind(1, entry->place).bind(2, entry->source).bind(7, entry->settings).bind(8, entry->dialect);
    bind_file(put_, 3, entry->program);
    put_.bind(9, called).bind(10, entry->folder_changed_ns);
    bind_file(put_, 11, entry->output);
    put_.bind(15, std::int64_t{entry->has_undo}).bind(16, entry->summary);
    put_.step();
  }
  transaction.commit();
}

void Record::remove(const std::vector<std::string>& places) {
  if (places.empty()) return;
  const std::scoped_lock lock(guard_);
  Transaction transaction(database_);
  for (const std::string& place : places) {
    remove_.bind(1, place);
    remove_.step();
  }
  transaction.commit();
}

void Record::each(const std::function<void(const Entry&)>& take) {
  const std::scoped_lock lock(guard_);
  Statement all(database_, kEach);
  while (all.step()) take(entry_at(all));
}

}  // namespace plumbline::batch
