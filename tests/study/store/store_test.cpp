#include "study/store/store.h"

#include <fcntl.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <thread>

#include "base/errors.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

Evaluation sample(const std::string& key) {
  Evaluation e;
  e.key = key;
  e.name = "design " + key;
  e.status = EvaluationStatus::ok;
  e.parameters = {{"/bow/stem_deg", 0.1 + 0.2}};
  e.result = {{"design", e.name}, {"x", 1.0 / 3.0}};
  e.wall_seconds = 1.5;
  return e;
}

std::string message_of_open(const std::string& path) {
  try {
    Store::open(path);
  } catch (const RuntimeError& error) {
    return error.what();
  }
  return "";
}

// Puts rows for ever, and says so after each.
[[noreturn]] void write_for_ever(const std::string& path, Journal journal, int acknowledge, int round) {
  Store store = Store::open(path, journal);
  for (int i = 0;; ++i) {
    const std::string key = std::to_string(round) + "." + std::to_string(i) + "\n";
    store.put(sample(key.substr(0, key.size() - 1)));
    if (write(acknowledge, key.data(), key.size()) < 0) _exit(1);
  }
}

std::string acknowledged_before_kill(const std::string& path, Journal journal, int round) {
  int ends[2];
  REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
  const pid_t child = fork();
  if (child == 0) write_for_ever(path, journal, ends[1], round);
  close(ends[1]);
  std::string text;
  char buffer[256];
  ssize_t n = read(ends[0], buffer, sizeof buffer);  // it has begun
  if (n > 0) text.append(buffer, n);
  std::this_thread::sleep_for(std::chrono::milliseconds(3 + 7 * round % 23));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  while ((n = read(ends[0], buffer, sizeof buffer)) > 0) text.append(buffer, n);
  close(ends[0]);
  return text.substr(0, text.rfind('\n') + 1);
}

}  // namespace

TEST_CASE("what is put is found, to the last bit") {
  const TemporaryDirectory directory;
  const Evaluation put = sample("a");
  { Store::open(directory / "r.sqlite").put(put); }
  const Store store = Store::open_read_only(directory / "r.sqlite");
  const auto found = store.find("a");
  REQUIRE(found);
  CHECK(to_json(*found) == to_json(put));
  CHECK_FALSE(store.find("b"));
  CHECK(store.find_name("design a")->key == "a");
}

TEST_CASE("a row is replaced by its key and keeps its place") {
  const TemporaryDirectory directory;
  Store store = Store::open(directory / "r.sqlite");
  for (const char* key : {"c", "a", "b"}) store.put(sample(key));
  Evaluation failed = sample("a");
  failed.status = EvaluationStatus::failed;
  failed.reason = "because";
  failed.wall_seconds = std::numeric_limits<double>::quiet_NaN();
  failed.parameters["/nan"] = std::numeric_limits<double>::quiet_NaN();
  store.put(failed);
  const auto all = store.all();
  REQUIRE(all.size() == 3);
  CHECK(all[1].key == "a");
  CHECK(all[1].status == EvaluationStatus::failed);
  CHECK(all[1].reason == "because");
  CHECK(std::isnan(all[1].wall_seconds));
  CHECK(std::isnan(all[1].parameters.at("/nan")));
  store.remove("c");
  CHECK(store.all().size() == 2);
}

TEST_CASE("all() is the present study in its order; older rows stay in everything()") {
  const TemporaryDirectory directory;
  Store store = Store::open(directory / "r.sqlite");
  for (const char* key : {"a", "b", "c"}) store.put(sample(key));
  store.begin_study({"c", "not run yet", "a"});
  CHECK(store.all().size() == 2);
  CHECK(store.all()[0].key == "c");
  CHECK(store.all()[1].key == "a");
  CHECK(store.everything().size() == 3);
  store.add_to_study("b");
  store.add_to_study("b");
  CHECK(store.all().size() == 3);
}

TEST_CASE("a store at rest is one file") {
  const TemporaryDirectory directory;
  const std::string path = directory / "r.sqlite";
  {
    Store store = Store::open(path);
    store.put(sample("a"));
    CHECK(std::filesystem::exists(path + "-wal"));
  }
  CHECK_FALSE(std::filesystem::exists(path + "-wal"));
  CHECK(Store::open_read_only(path).find("a"));
  CHECK_FALSE(std::filesystem::exists(path + "-wal"));
  { Store::open(path).put(sample("b")); }
  CHECK(Store::open_read_only(path).all().size() == 2);
}

TEST_CASE("facts") {
  const TemporaryDirectory directory;
  Store store = Store::open(directory / "r.sqlite");
  CHECK(store.fact("seed").empty());
  store.set_fact("seed", "1");
  store.set_fact("seed", "2");
  CHECK(store.fact("seed") == "2");
}

TEST_CASE("a second writer is refused by name of the first, a reader is not") {
  const TemporaryDirectory directory;
  const std::string path = directory / "r.sqlite";
  for (const Journal journal : {Journal::automatic, Journal::rollback}) {
    Store writer = Store::open(path, journal);
    writer.put(sample("a"));
    CHECK_THAT(message_of_open(path),
               Catch::Contains("another icebow run") && Catch::Contains(std::to_string(getpid())));
    const Store reader = Store::open_read_only(path);
    CHECK(reader.find("a"));
    writer.put(sample("b"));  // while the reader is open
    CHECK(reader.find("b"));
    writer.remove("b");
  }
  CHECK(message_of_open(path).empty());  // given back
}

TEST_CASE("what is not a store is refused and left alone") {
  const TemporaryDirectory directory;
  const std::string text = directory / "notes.txt", other = directory / "other.sqlite";
  write_text_file(text, std::string(2000, 'x'));
  CHECK_THAT(message_of_open(text), Catch::Contains("notes.txt") && Catch::Contains("not a result store"));
  CHECK(read_text_file(text) == std::string(2000, 'x'));

  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open(other.c_str(), &database) == SQLITE_OK);
  sqlite3_exec(database, "CREATE TABLE mine (x)", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  const std::string before = read_text_file(other);
  CHECK_THAT(message_of_open(other), Catch::Contains("not a result store"));
  CHECK(read_text_file(other) == before);

  CHECK_THROWS_AS(Store::open_read_only(directory / "none.sqlite"), RuntimeError);
  CHECK_THROWS_AS(Store::open(directory / "no/such/place.sqlite"), RuntimeError);
}

TEST_CASE("a store of another schema is refused") {
  const TemporaryDirectory directory;
  const std::string path = directory / "r.sqlite";
  { Store::open(path); }
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open(path.c_str(), &database) == SQLITE_OK);
  sqlite3_exec(database, "PRAGMA user_version = 99", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  CHECK_THAT(message_of_open(path), Catch::Contains("schema 99"));
}

TEST_CASE("a killed writer loses nothing it has acknowledged") {
  for (const Journal journal : {Journal::automatic, Journal::rollback}) {
    const TemporaryDirectory directory;
    const std::string path = directory / "r.sqlite";
    std::string acknowledged;
    for (int round = 0; round < 12; ++round) acknowledged += acknowledged_before_kill(path, journal, round);
    const Store store = Store::open(path, journal);
    int keys = 0;
    for (std::size_t at = 0, end; (end = acknowledged.find('\n', at)) != std::string::npos;
         at = end + 1, ++keys) {
      const std::string key = acknowledged.substr(at, end - at);
      const auto found = store.find(key);
      REQUIRE(found);
      CHECK(to_json(*found) == to_json(sample(key)));
    }
    CHECK(keys >= 12);
  }
}

namespace {

void change(const std::string& path, const std::string& sql) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open(path.c_str(), &database) == SQLITE_OK);
  REQUIRE(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  sqlite3_close(database);
}

std::string message_of_reading(const std::string& path) {
  try {
    const Store store = Store::open_read_only(path);
    store.all();
    store.fact("rank_by");
  } catch (const RuntimeError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the list of designs and the facts carry digests too") {
  const TemporaryDirectory directory;
  const std::string path = directory / "r.sqlite";
  {
    Store store = Store::open(path);
    store.put(sample("a"));
    store.begin_study({"a", "b"});
    store.set_fact("rank_by", "mean_load");
  }
  CHECK(message_of_reading(path).empty());
  change(path, "UPDATE facts SET value = 'mean_lobd'");
  CHECK_THAT(message_of_reading(path), Catch::Contains("rank_by") && Catch::Contains("command again"));
  { Store::open(path).set_fact("rank_by", "mean_load"); }
  change(path, "UPDATE study SET key = 'c' WHERE key = 'a'");
  CHECK_THAT(message_of_reading(path), Catch::Contains("list of the study's designs is damaged"));
  { Store::open(path).begin_study({"a", "b"}); }
  CHECK(message_of_reading(path).empty());
}

TEST_CASE("a store without digests is read, and given them when it is written to") {
  const TemporaryDirectory directory;
  const std::string path = directory / "r.sqlite";
  {
    Store store = Store::open(path);
    store.put(sample("a"));
    store.begin_study({"a"});
    store.set_fact("rank_by", "mean_load");
  }
  change(path,
         "ALTER TABLE evaluations DROP COLUMN digest; ALTER TABLE study DROP COLUMN digest;"
         "ALTER TABLE facts DROP COLUMN digest; PRAGMA user_version = 1");
  CHECK(message_of_reading(path).empty());
  CHECK(Store::open_read_only(path).all().at(0).status == EvaluationStatus::ok);
  { Store::open(path); }
  CHECK(Store::open_read_only(path).all().at(0).status == EvaluationStatus::ok);
  change(path, "UPDATE evaluations SET reason = 'x'");
  CHECK(Store::open_read_only(path).all().at(0).status == EvaluationStatus::damaged);
}

TEST_CASE("a bit flipped anywhere in a store is told, or changes nothing") {
  const TemporaryDirectory directory;
  const std::string path = directory / "r.sqlite", copy = directory / "c.sqlite";
  {
    Store store = Store::open(path);
    for (const char* key : {"a", "b", "c"}) store.put(sample(key));
    store.begin_study({"c", "a", "b"});
    store.set_fact("rank_by", "mean_load");
  }
  const auto seen = [](const std::string& file) {
    const Store store = Store::open_read_only(file);
    std::string text = store.fact("rank_by");
    for (const Evaluation& e : store.all()) {
      if (e.status == EvaluationStatus::damaged) throw RuntimeError("told");
      text += json_text(to_json(e));
    }
    return text;
  };
  const std::string whole = read_text_file(path), expected = seen(path);
  int told = 0, unchanged = 0, believed = 0;
  for (std::size_t at = 0; at < whole.size(); at += 37) {  // every byte of some, prime to the pages
    std::string text = whole;
    text[at] = static_cast<char>(text[at] ^ (1 << (at % 8)));
    std::ofstream(copy, std::ios::binary | std::ios::trunc) << text;
    try {
      ++(seen(copy) == expected ? unchanged : believed);
    } catch (const RuntimeError&) {
      ++told;
    }
  }
  CHECK(believed == 0);
  CHECK(told > 20);
  CHECK(unchanged > 20);  // in parts of pages that hold nothing
}

TEST_CASE("a reader does not wait long for a store that somebody holds locked") {
  const TemporaryDirectory directory;
  const std::string path = directory / "r.sqlite";
  { Store::open(path).put(sample("a")); }
  sqlite3* holder = nullptr;
  REQUIRE(sqlite3_open(path.c_str(), &holder) == SQLITE_OK);
  REQUIRE(sqlite3_exec(holder, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr) == SQLITE_OK);
  const auto begin = std::chrono::steady_clock::now();
  CHECK_THAT(message_of_reading(path), Catch::Contains("holds it locked"));
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(8));  // 2 s, on a busy machine more
  sqlite3_close(holder);
}

TEST_CASE("a store that another program locks is waited for as long as the caller is patient") {
  for (const Journal journal : {Journal::automatic, Journal::rollback}) {
    const TemporaryDirectory directory;
    double waited = 0.0, patience = 10.0;
    Store store = Store::open(directory / "r.sqlite", journal, [&](double seconds) {
      waited = seconds;
      return seconds < patience;
    });
    sqlite3* other = nullptr;
    REQUIRE(sqlite3_open((directory / "r.sqlite").c_str(), &other) == SQLITE_OK);
    REQUIRE(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr) == SQLITE_OK);
    std::thread releases([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      sqlite3_exec(other, "COMMIT", nullptr, nullptr, nullptr);
    });
    store.put(sample("a"));
    releases.join();
    CHECK(waited > 0.1);
    CHECK(store.find("a"));
    REQUIRE(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr) == SQLITE_OK);
    patience = 0.1;
    CHECK_THROWS_WITH(store.put(sample("b")), Catch::Contains("another program holds it locked"));
    sqlite3_close(other);
  }
}

TEST_CASE("a name is looked up by an index, in stores of earlier programs too") {
  const TemporaryDirectory directory;
  Store::open(directory / "r.sqlite").put(sample("a"));
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open((directory / "r.sqlite").c_str(), &database) == SQLITE_OK);
  REQUIRE(sqlite3_exec(database, "DROP INDEX evaluations_by_name", nullptr, nullptr, nullptr) == SQLITE_OK);
  sqlite3_close(database);
  { const Store again = Store::open(directory / "r.sqlite"); }
  REQUIRE(sqlite3_open((directory / "r.sqlite").c_str(), &database) == SQLITE_OK);
  sqlite3_stmt* plan = nullptr;
  REQUIRE(sqlite3_prepare_v2(database,
                             "EXPLAIN QUERY PLAN SELECT id FROM evaluations e WHERE e.name = ? ORDER BY e.id",
                             -1, &plan, nullptr) == SQLITE_OK);
  REQUIRE(sqlite3_step(plan) == SQLITE_ROW);
  CHECK_THAT(reinterpret_cast<const char*>(sqlite3_column_text(plan, 3)),
             Catch::Contains("USING") && Catch::Contains("evaluations_by_name"));
  sqlite3_finalize(plan);
  sqlite3_close(database);
}

TEST_CASE("a pipe in the place of a store, or of what SQLite keeps beside it, keeps nobody waiting") {
  for (const char* ending : {"", "-journal", "-wal", "-shm"}) {
    const TemporaryDirectory directory;
    const std::string path = directory / "r.sqlite";
    if (*ending) Store::open(path).put(sample("a"));
    INFO(ending);
    REQUIRE(mkfifo((path + ending).c_str(), 0600) == 0);
    CHECK_THAT(message_of_reading(path), Catch::Contains(path + ending + ": is a pipe"));
    CHECK_THROWS_WITH(Store::open(path), Catch::Contains(path + ending + ": is a pipe"));
  }
}

TEST_CASE("a store with a program of somebody's in it is refused before the program runs") {
  for (const char* sql :
       {"CREATE TRIGGER gone AFTER INSERT ON evaluations BEGIN DELETE FROM evaluations; END",
        "CREATE VIEW endless AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) "
        "SELECT x FROM c"}) {
    const TemporaryDirectory directory;
    const std::string path = directory / "r.sqlite";
    { Store::open(path).put(sample("a")); }
    change(path, sql);
    INFO(sql);
    CHECK_THAT(message_of_reading(path), Catch::Contains("somebody has altered it"));
    CHECK_THROWS_WITH(Store::open(path), Catch::Contains("somebody has altered it"));
  }
}
