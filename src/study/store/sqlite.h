// SQLite with destructors and exceptions. Included by store.cpp only.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace icebow {

// Asked again and again, some fifty times a second, while another program holds the file locked, with the
// seconds that it has been waited for; false gives up. Must not throw.
using Waiting = std::function<bool(double seconds)>;

class Database {
 public:
  // Both throw RuntimeError naming the file. Without `waiting` the writer gives up after 20 s.
  static Database open(const std::string& path, Waiting waiting = {});
  static Database open_read_only(const std::string& path);  // does not wait long where it is locked
  Database(Database&& other) noexcept;
  ~Database();

  void execute(const std::string& sql);
  void try_at_once(const std::string& sql) noexcept;  // without waiting for others, and without complaint
  std::string text_of(
      const std::string& sql) const;  // first column of the first row; empty where there is none
  [[noreturn]] void fail(const std::string& doing) const;
  sqlite3* handle() const { return handle_; }
  const std::string& path() const { return path_; }

 private:
  struct Patience {
    Waiting waiting;
    std::chrono::steady_clock::time_point since;
  };
  static int wait(void* patience, int tries);
  Database(std::string path, int flags);
  void be_patient();
  std::string path_;
  sqlite3* handle_ = nullptr;
  std::unique_ptr<Patience> patience_ = std::make_unique<Patience>();
};

// One prepared statement: bind in order, step through the rows, read by column number.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(const std::string& text);
  Statement& bind(double value);  // NaN becomes NULL
  Statement& bind(std::int64_t value);
  bool step();  // true where there is a row to read
  void run() {
    while (step()) {
    }
  }

  std::string text(int column) const;
  double number(int column) const;  // NULL becomes NaN
  std::int64_t integer(int column) const;

 private:
  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
};

}  // namespace icebow
