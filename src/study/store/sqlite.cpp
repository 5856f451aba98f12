#include "study/store/sqlite.h"

#include <sqlite3.h>

#include <filesystem>
#include <limits>
#include <thread>
#include <utility>

#include "base/errors.h"

namespace icebow {
namespace {

constexpr double usual_wait = 20.0;    //!< [s] a reader of a rollback journal holds the writer up for moments
constexpr int reader_waits_ms = 2000;  // the writer holds readers of one up for moments, too
constexpr std::chrono::milliseconds moment(20);

std::string what_to_do(int code) {
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "; another program holds it locked: close that program and run the same command again";
    case SQLITE_FULL:
      return "; the disk is full, what was stored before is kept: make room and run the same command again";
    case SQLITE_CORRUPT:
      return "; the file is damaged: put a copy of it in its place, or move it away and run the study's "
             "command "
             "again, which evaluates its designs anew";
    case SQLITE_IOERR:
      return "; the disk, or a limit on sizes of files (ulimit -f, a quota), does not allow it: see to that "
             "and run the "
             "same command again";
    case SQLITE_NOTADB:
      return "; this is not a result store of icebow";
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
      return "; check that the file and its directory exist and may be written";
    default:
      return "";
  }
}

// A store on read-only media, its log folded in: SQLite reads it without locks or shared memory.
std::string immutable_uri(const std::string& path) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    if (c == '%' || c == '?' || c == '#') {
      uri += c == '%' ? "%25" : c == '?' ? "%3f" : "%23";
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

// SQLite opens whatever has these names, and waits for ever at a pipe.
void refuse_what_is_no_file(const std::string& path) {
  for (const char* ending : {"", "-journal", "-wal", "-shm"}) {
    std::error_code error;
    const auto status = std::filesystem::status(path + ending, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
      throw RuntimeError(path + ending + ": is a pipe, a directory or a device, and no file; remove it");
  }
}

}  // namespace

Database::Database(std::string path, int flags) : path_(std::move(path)) {
  if (sqlite3_open_v2(path_.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
    try {
      fail("cannot be opened");
    } catch (...) {  // the destructor of a half-made object is not called
      sqlite3_close(handle_);
      throw;
    }
  }
  be_patient();
}

Database::Database(Database&& other) noexcept
    : path_(std::move(other.path_)),
      handle_(std::exchange(other.handle_, nullptr)),
      patience_(std::move(other.patience_)) {}

Database::~Database() {
  sqlite3_close(handle_);
}

// SQLite's handler of a lock that somebody else holds. `tries` starts from 0 for each lock.
int Database::wait(void* patience, int tries) {
  Patience& p = *static_cast<Patience*>(patience);
  const auto now = std::chrono::steady_clock::now();
  if (tries == 0) p.since = now;
  const double seconds = std::chrono::duration<double>(now - p.since).count();
  if (p.waiting ? !p.waiting(seconds) : seconds > usual_wait) return 0;
  std::this_thread::sleep_for(moment);
  return 1;
}

void Database::be_patient() {
  sqlite3_busy_handler(handle_, wait, patience_.get());
}

Database Database::open(const std::string& path, Waiting waiting) {
  refuse_what_is_no_file(path);
  Database database(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  database.patience_->waiting = std::move(waiting);
  return database;
}

Database Database::open_read_only(const std::string& path) {
  refuse_what_is_no_file(path);
  Database database(path, SQLITE_OPEN_READONLY);
  sqlite3_busy_timeout(database.handle_, reader_waits_ms);
  const bool readable = sqlite3_exec(database.handle_, "SELECT count(*) FROM sqlite_master", nullptr, nullptr,
                                     nullptr) == SQLITE_OK;
  const int code = sqlite3_errcode(database.handle_);
  if (!readable && (code & 0xff) == SQLITE_BUSY) database.fail("cannot be read");
  const bool no_shared_memory = (code & 0xff) == SQLITE_CANTOPEN || (code & 0xff) == SQLITE_READONLY;
  std::error_code missing;
  const auto log_size = std::filesystem::file_size(path + "-wal", missing);
  if (readable || !no_shared_memory || (!missing && log_size > 0)) return database;
  return Database(immutable_uri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail("cannot be used");
}

void Database::try_at_once(const std::string& sql) noexcept {
  sqlite3_busy_timeout(handle_, 0);
  sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  be_patient();
}

std::string Database::text_of(const std::string& sql) const {
  Statement statement(*this, sql);
  return statement.step() ? statement.text(0) : "";
}

void Database::fail(const std::string& doing) const {
  const int code = handle_ ? sqlite3_errcode(handle_) : SQLITE_NOMEM;
  const std::string message = handle_ ? sqlite3_errmsg(handle_) : "out of memory";
  throw RuntimeError(path_ + ": " + doing + ": " + message + what_to_do(code));
}

Statement::Statement(const Database& database, const std::string& sql) : database_(database) {
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK) {
    database.fail("cannot be read");
  }
}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

Statement& Statement::bind(const std::string& text) {
  sqlite3_bind_text64(statement_, ++bound_, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  return *this;
}

Statement& Statement::bind(double value) {
  sqlite3_bind_double(statement_, ++bound_, value);
  return *this;
}

Statement& Statement::bind(std::int64_t value) {
  sqlite3_bind_int64(statement_, ++bound_, value);
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE)
    database_.fail(sqlite3_stmt_readonly(statement_) ? "cannot be read" : "cannot be written");
  return false;
}

std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return bytes ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))) : "";
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

double Statement::number(int column) const {
  if (sqlite3_column_type(statement_, column) == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(statement_, column);
}

}  // namespace icebow
