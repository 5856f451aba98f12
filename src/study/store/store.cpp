#include "study/store/store.h"

#include <filesystem>

#include "base/errors.h"
#include "study/store/sqlite.h"
#include "study/store/store_lock.h"

namespace icebow {
namespace {

constexpr int schema_version = 1;
constexpr int application_id = 0x49434257;  // "ICBW": tells a store from any other SQLite file

constexpr const char* schema = R"sql(
  CREATE TABLE evaluations (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE,
    name TEXT NOT NULL,
    status TEXT NOT NULL CHECK (status IN ('ok', 'infeasible', 'failed', 'running')),
    reason TEXT NOT NULL,
    wall_seconds REAL,
    parameters TEXT NOT NULL,
    result TEXT NOT NULL
  );
  CREATE TABLE study (position INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE);
  CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL);
)sql";

constexpr const char* columns =
    "SELECT e.key, e.name, e.status, e.reason, e.wall_seconds, e.parameters, e.result FROM evaluations e ";

Evaluation row(const Statement& statement) {
  Evaluation e;
  e.key = statement.text(0);
  e.name = statement.text(1);
  e.status = status_from_string(statement.text(2));
  e.reason = statement.text(3);
  e.wall_seconds = statement.number(4);
  e.parameters = parameters_from_json(parse_json(statement.text(5), "parameters of " + e.name));
  e.result = parse_json(statement.text(6), "result of " + e.name);
  return e;
}

std::vector<Evaluation> rows(const Database& database, const std::string& rest) {
  Statement statement(database, columns + rest);
  std::vector<Evaluation> evaluations;
  while (statement.step()) evaluations.push_back(row(statement));
  return evaluations;
}

void check_is_store(const Database& database, const std::string& path) {
  if (database.text_of("PRAGMA application_id") != std::to_string(application_id)) {
    throw RuntimeError(path + ": this SQLite file is not a result store of icebow; choose another directory");
  }
  const std::string version = database.text_of("PRAGMA user_version");
  if (version != std::to_string(schema_version)) {
    throw RuntimeError(path + ": written by another version of icebow (schema " + version +
                       ", this one reads " + std::to_string(schema_version) +
                       "); use that version, or choose another directory");
  }
}

// True where the file is new: without tables of anybody's.
bool is_blank(const Database& database) {
  return database.text_of("SELECT count(*) FROM sqlite_master") == "0" &&
         database.text_of("PRAGMA application_id") == "0";
}

void create(Database& database) {
  database.execute("BEGIN IMMEDIATE");
  database.execute(schema);
  database.execute("PRAGMA application_id = " + std::to_string(application_id));
  database.execute("PRAGMA user_version = " + std::to_string(schema_version));
  database.execute("COMMIT");
}

// The answer to the pragma is the mode that was got: where WAL cannot be had the rollback journal stays.
void choose_journal(Database& database, const std::string& path, Journal journal) {
  const bool wal = journal == Journal::automatic && !on_network_file_system(path);
  try {
    database.text_of(wal ? "PRAGMA journal_mode = WAL" : "PRAGMA journal_mode = DELETE");
  } catch (const RuntimeError&) {
    database.text_of("PRAGMA journal_mode = DELETE");
  }
  database.execute("PRAGMA synchronous = FULL");
}

}  // namespace

struct Store::Impl {
  std::unique_ptr<StoreLock>
      lock;  // none for a reader; declared first, so given back after the file is closed
  Database database;

  // A store at rest is one file, to be copied or read from anywhere. While somebody reads, its log stays
  // beside it.
  ~Impl() {
    if (lock) database.try_at_once("PRAGMA journal_mode = DELETE");
  }
};

Store::Store(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Store::Store(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::open(const std::string& path, Journal journal) {
  auto lock = std::make_unique<StoreLock>(path + ".lock");
  Database database = Database::open(path);
  if (!is_blank(database))
    check_is_store(database, path);  // before anything is written to a file of somebody else
  choose_journal(database, path, journal);
  if (is_blank(database)) create(database);
  return Store(std::unique_ptr<Impl>(new Impl{std::move(lock), std::move(database)}));
}

Store Store::open_read_only(const std::string& path) {
  if (!std::filesystem::exists(path)) throw RuntimeError(path + ": there is no result store");
  Database database = Database::open_read_only(path);
  check_is_store(database, path);
  return Store(std::unique_ptr<Impl>(new Impl{nullptr, std::move(database)}));
}

std::optional<Evaluation> Store::find(const std::string& key) const {
  Statement statement(impl_->database, std::string(columns) + "WHERE e.key = ?");
  if (!statement.bind(key).step()) return std::nullopt;
  return row(statement);
}

std::optional<Evaluation> Store::find_name(const std::string& name) const {
  Statement statement(impl_->database, std::string(columns) + "WHERE e.name = ? ORDER BY e.id");
  if (!statement.bind(name).step()) return std::nullopt;
  return row(statement);
}

void Store::put(const Evaluation& e) {
  Statement(impl_->database,
            "INSERT INTO evaluations (key, name, status, reason, wall_seconds, parameters, result) "
            "VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT (key) DO UPDATE SET name = excluded.name, "
            "status = excluded.status, reason = excluded.reason, wall_seconds = excluded.wall_seconds, "
            "parameters = excluded.parameters, result = excluded.result")
      .bind(e.key)
      .bind(e.name)
      .bind(std::string(to_string(e.status)))
      .bind(e.reason)
      .bind(e.wall_seconds)
      .bind(json_text(parameters_json(e.parameters)))
      .bind(json_text(e.result))
      .run();
}

void Store::remove(const std::string& key) {
  Statement(impl_->database, "DELETE FROM evaluations WHERE key = ?").bind(key).run();
}

std::vector<Evaluation> Store::all() const {
  if (impl_->database.text_of("SELECT count(*) FROM study") == "0") return everything();
  return rows(impl_->database, "JOIN study s ON s.key = e.key ORDER BY s.position");
}

std::vector<Evaluation> Store::everything() const {
  return rows(impl_->database, "ORDER BY e.id");
}

void Store::begin_study(const std::vector<std::string>& keys) {
  impl_->database.execute("BEGIN IMMEDIATE");
  try {
    impl_->database.execute("DELETE FROM study");
    for (const std::string& key : keys) add_to_study(key);
    impl_->database.execute("COMMIT");
  } catch (...) {
    Statement(impl_->database, "ROLLBACK").run();
    throw;
  }
}

void Store::add_to_study(const std::string& key) {
  Statement(impl_->database, "INSERT INTO study (key) VALUES (?) ON CONFLICT DO NOTHING").bind(key).run();
}

void Store::set_fact(const std::string& name, const std::string& value) {
  Statement(impl_->database,
            "INSERT INTO facts (name, value) VALUES (?, ?) "
            "ON CONFLICT (name) DO UPDATE SET value = excluded.value")
      .bind(name)
      .bind(value)
      .run();
}

std::string Store::fact(const std::string& name) const {
  Statement statement(impl_->database, "SELECT value FROM facts WHERE name = ?");
  return statement.bind(name).step() ? statement.text(0) : "";
}

}  // namespace icebow
