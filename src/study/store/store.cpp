#include "study/store/store.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "base/error_words.h"
#include "base/errors.h"
#include "base/printable.h"
#include "base/sha256.h"
#include "study/spec/design_name.h"
#include "study/store/sqlite.h"
#include "study/store/store_lock.h"

namespace icebow {
namespace {

constexpr int schema_version = 2, without_digests = 1;
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
    result TEXT NOT NULL,
    digest TEXT
  );
  CREATE TABLE study (position INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, digest TEXT);
  CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL, digest TEXT);
)sql";

// One look-up by name for each design of a study. An earlier version of the program minds it as little as it
// needs it.
constexpr const char* add_index = "CREATE INDEX IF NOT EXISTS evaluations_by_name ON evaluations (name)";

constexpr const char* add_digests = R"sql(
  ALTER TABLE evaluations ADD COLUMN digest TEXT;
  ALTER TABLE study ADD COLUMN digest TEXT;
  ALTER TABLE facts ADD COLUMN digest TEXT;
)sql";

constexpr const char* columns =
    "SELECT e.id, e.key, e.name, e.status, e.reason, e.wall_seconds, e.parameters, e.result, ";

// A row as it stands in the file.
struct Row {
  std::int64_t id = 0;
  std::string key, name, status, reason, parameters, result, digest;
  double wall_seconds = 0.0;
};

Row row(const Statement& s) {
  return {s.integer(0), s.text(1), s.text(2), s.text(3),  s.text(4),
          s.text(6),    s.text(7), s.text(8), s.number(5)};
}

// Lengths stand before the texts, so that no two rows read the same.
std::string digest_of(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += std::to_string(text.size()) + ":" + text;
  return sha256(all);
}

std::string digest_of(const Row& r) {
  char seconds[40];
  std::snprintf(seconds, sizeof seconds, "%a", std::isnan(r.wall_seconds) ? -1.0 : r.wall_seconds);
  return digest_of({r.key, r.name, r.status, r.reason, seconds, r.parameters, r.result});
}

std::string digest_of_place(std::int64_t position, const std::string& key) {
  return digest_of({std::to_string(position), key});
}

Evaluation damaged(const Row& r, const std::string& why) {
  Evaluation e;
  e.key = r.key;
  e.name = is_stored_name(r.name) ? r.name : "row " + std::to_string(r.id);
  e.status = EvaluationStatus::damaged;
  e.reason = "its row in results.sqlite " + why +
             "; `icebow run` with --retry-failed evaluates it again, the other designs stand";
  e.wall_seconds = std::numeric_limits<double>::quiet_NaN();
  return e;
}

Evaluation evaluation(const Row& r, bool digests) {
  if (digests && r.digest != digest_of(r)) return damaged(r, "is damaged: it does not fit its digest");
  if (!is_stored_name(r.name)) return damaged(r, "is damaged: its name is no design's");
  try {
    Evaluation e;
    e.key = r.key;
    e.name = r.name;
    e.status = status_from_string(r.status);
    e.reason = r.reason;
    e.wall_seconds = r.wall_seconds;
    e.parameters = parameters_from_json(parse_json(r.parameters, "parameters"));
    e.result = parse_json(r.result, "result");
    return e;
  } catch (const std::exception& error) {
    return damaged(r, std::string("cannot be read: ") + in_words(error));
  }
}

void check_is_store(const Database& database, const std::string& path) {
  if (database.text_of("PRAGMA application_id") != std::to_string(application_id)) {
    throw RuntimeError(path + ": this SQLite file is not a result store of icebow; choose another directory");
  }
  const std::string version = database.text_of("PRAGMA user_version");
  if (version != std::to_string(schema_version) && version != std::to_string(without_digests)) {
    throw RuntimeError(path + ": written by another version of icebow (schema " + version +
                       ", this one reads " + std::to_string(schema_version) +
                       "); use that version, or choose another directory");
  }
  // Views, triggers and virtual tables are programs that run when a store is read or written.
  const std::string program = database.text_of(
      "SELECT type || ' ' || name FROM sqlite_master WHERE type NOT IN ('table', 'index') OR sql LIKE "
      "'CREATE VIRTUAL%'");
  if (!program.empty())
    throw RuntimeError(path + ": holds a " + shortened(program, 80) +
                       ", which no store of icebow does: somebody has altered it; choose another directory");
}

// Pages that are not what SQLite wrote.
void check_is_whole(const Database& database, const std::string& path) {
  const std::string trouble = database.text_of("PRAGMA integrity_check(1)");
  if (trouble == "ok") return;
  throw RuntimeError(
      path + ": the file is damaged (" + shortened(trouble, 120) +
      "): put a copy of it in its place, or move it away and run the study's command again, which "
      "evaluates its designs anew");
}

bool has_digests(const Database& database) {
  return database.text_of("PRAGMA user_version") != std::to_string(without_digests);
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
  bool digests = true;

  std::vector<Evaluation> evaluations(const std::string& rest, const std::string& key_or_name = "") const {
    Statement statement(database,
                        columns + std::string(digests ? "e.digest" : "NULL") + " FROM evaluations e " + rest);
    if (!key_or_name.empty()) statement.bind(key_or_name);
    std::vector<Evaluation> list;
    while (statement.step()) list.push_back(evaluation(row(statement), digests));
    return list;
  }

  std::optional<Evaluation> first(const std::string& rest, const std::string& key_or_name) const {
    std::vector<Evaluation> list = evaluations(rest, key_or_name);
    if (list.empty()) return std::nullopt;
    return std::move(list.front());
  }

  void put(const Row& r) {
    Statement(database,
              "INSERT INTO evaluations (key, name, status, reason, wall_seconds, parameters, result, digest) "
              "VALUES (?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (key) DO UPDATE SET name = excluded.name, "
              "status = excluded.status, reason = excluded.reason, wall_seconds = excluded.wall_seconds, "
              "parameters = excluded.parameters, result = excluded.result, digest = excluded.digest")
        .bind(r.key)
        .bind(r.name)
        .bind(r.status)
        .bind(r.reason)
        .bind(r.wall_seconds)
        .bind(r.parameters)
        .bind(r.result)
        .bind(digest_of(r))
        .run();
  }

  void check_list() const {
    if (!digests) return;
    Statement statement(database, "SELECT position, key, digest FROM study");
    while (statement.step())
      if (statement.text(2) != digest_of_place(statement.integer(0), statement.text(1)))
        throw RuntimeError(
            database.path() +
            ": the list of the study's designs is damaged; run the study's command again, which writes "
            "it anew and takes the results that are there");
  }

  // What a version without digests has written is believed.
  void migrate() {
    database.execute("BEGIN IMMEDIATE");
    database.execute(add_digests);
    std::vector<Row> all;
    {
      Statement statement(database, columns + std::string("NULL FROM evaluations e"));
      while (statement.step()) all.push_back(row(statement));
    }
    for (const Row& r : all) put(r);
    add_other_digests();
    database.execute("PRAGMA user_version = " + std::to_string(schema_version));
    database.execute("COMMIT");
  }

  void add_other_digests() {
    std::vector<std::pair<std::int64_t, std::string>> places;
    std::vector<std::pair<std::string, std::string>> facts;
    {
      Statement list(database, "SELECT position, key FROM study"),
          words(database, "SELECT name, value FROM facts");
      while (list.step()) places.emplace_back(list.integer(0), list.text(1));
      while (words.step()) facts.emplace_back(words.text(0), words.text(1));
    }
    for (const auto& [position, key] : places)
      Statement(database, "UPDATE study SET digest = ? WHERE position = ?")
          .bind(digest_of_place(position, key))
          .bind(position)
          .run();
    for (const auto& [name, value] : facts)
      Statement(database, "UPDATE facts SET digest = ? WHERE name = ?")
          .bind(digest_of({name, value}))
          .bind(name)
          .run();
  }

  // A store at rest is one file, to be copied or read from anywhere. While somebody reads, its log stays
  // beside it.
  ~Impl() {
    if (lock) database.try_at_once("PRAGMA journal_mode = DELETE");
  }
};

Store::Store(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Store::Store(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::open(const std::string& path, Journal journal, Waiting waiting) {
  auto lock = std::make_unique<StoreLock>(path + ".lock");
  Database database = Database::open(path, std::move(waiting));
  const bool blank = is_blank(database);
  if (!blank) {
    check_is_store(database, path);  // before anything is written to a file of somebody else
    check_is_whole(database, path);
  }
  choose_journal(database, path, journal);
  if (blank) create(database);
  database.execute(add_index);
  const bool migrates = !has_digests(database);
  std::unique_ptr<Impl> impl(new Impl{std::move(lock), std::move(database)});
  if (migrates) impl->migrate();
  return Store(std::move(impl));
}

Store Store::open_read_only(const std::string& path) {
  if (std::filesystem::is_symlink(path))
    throw RuntimeError(path + ": is a link; name the directory that has the store itself");
  if (!std::filesystem::exists(path)) throw RuntimeError(path + ": there is no result store");
  Database database = Database::open_read_only(path);
  check_is_store(database, path);
  check_is_whole(database, path);
  const bool digests = has_digests(database);
  return Store(std::unique_ptr<Impl>(new Impl{nullptr, std::move(database), digests}));
}

std::optional<Evaluation> Store::find(const std::string& key) const {
  return impl_->first("WHERE e.key = ?", key);
}

std::optional<Evaluation> Store::find_name(const std::string& name) const {
  return impl_->first("WHERE e.name = ? ORDER BY e.id", name);
}

void Store::put(const Evaluation& e) {
  impl_->put({0, e.key, e.name, to_string(e.status), e.reason, json_text(parameters_json(e.parameters)),
              json_text(e.result), "", e.wall_seconds});
}

void Store::together(const std::function<void()>& work) {
  impl_->database.execute("BEGIN IMMEDIATE");
  try {
    work();
  } catch (...) {
    impl_->database.try_at_once("COMMIT");
    throw;
  }
  impl_->database.execute("COMMIT");
}

void Store::remove(const std::string& key) {
  Statement(impl_->database, "DELETE FROM evaluations WHERE key = ?").bind(key).run();
}

void Store::remove_damaged() {
  for (const Evaluation& e : everything())
    if (e.status == EvaluationStatus::damaged) remove(e.key);
}

std::vector<Evaluation> Store::all() const {
  if (impl_->database.text_of("SELECT count(*) FROM study") == "0") return everything();
  impl_->check_list();
  std::vector<Evaluation> list = impl_->evaluations("JOIN study s ON s.key = e.key ORDER BY s.position");
  for (Evaluation& e : impl_->evaluations("WHERE e.key NOT IN (SELECT key FROM study) ORDER BY e.id"))
    if (e.status == EvaluationStatus::damaged) list.push_back(std::move(e));
  return list;
}

std::vector<Evaluation> Store::everything() const {
  return impl_->evaluations("ORDER BY e.id");
}

void Store::begin_study(const std::vector<std::string>& keys) {
  impl_->database.execute("BEGIN IMMEDIATE");
  try {
    impl_->database.execute("DELETE FROM study");
    for (const std::string& key : keys) add_to_study(key);
    impl_->database.execute("COMMIT");
  } catch (...) {
    impl_->database.try_at_once("ROLLBACK");
    throw;
  }
}

void Store::add_to_study(const std::string& key) {
  Statement known(impl_->database, "SELECT 1 FROM study WHERE key = ?");
  if (known.bind(key).step()) return;
  const std::string last = impl_->database.text_of("SELECT max(position) FROM study");
  const std::int64_t position = last.empty() ? 1 : std::stoll(last) + 1;
  Statement(impl_->database, "INSERT INTO study (position, key, digest) VALUES (?, ?, ?)")
      .bind(position)
      .bind(key)
      .bind(digest_of_place(position, key))
      .run();
}

int Store::designs() const {
  return std::stoi(impl_->database.text_of("SELECT count(*) FROM study"));
}

void Store::set_fact(const std::string& name, const std::string& value) {
  Statement(impl_->database,
            "INSERT INTO facts (name, value, digest) VALUES (?, ?, ?) "
            "ON CONFLICT (name) DO UPDATE SET value = excluded.value, digest = excluded.digest")
      .bind(name)
      .bind(value)
      .bind(digest_of({name, value}))
      .run();
}

std::string Store::fact(const std::string& name) const {
  Statement statement(impl_->database, "SELECT value" + std::string(impl_->digests ? ", digest" : "") +
                                           " FROM facts WHERE name = ?");
  if (!statement.bind(name).step()) return "";
  const std::string value = statement.text(0);
  if (impl_->digests && statement.text(1) != digest_of({name, value}))
    throw RuntimeError(impl_->database.path() + ": what it says of the study (\"" + name +
                       "\") is damaged; run the study's command again, which writes it anew");
  return value;
}

std::string Store::fact_or_nothing(const std::string& name) const {
  try {
    return fact(name);
  } catch (const RuntimeError&) {
    return "";
  }
}

}  // namespace icebow
