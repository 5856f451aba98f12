#include "base/json.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/error_words.h"
#include "base/errors.h"
#include "base/json_words.h"
#include "base/printable.h"

using namespace icebow;

namespace {

std::vector<Mistake> mistakes_of(const std::string& text) {
  try {
    parse_json(text, "test.json");
  } catch (const InputError& e) {
    CHECK(e.file() == "test.json");
    return e.mistakes();
  }
  return {};
}

struct Directory {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("icebow_json_" + std::to_string(::getpid()));
  Directory() { std::filesystem::create_directories(path); }
  ~Directory() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
};

}  // namespace

TEST_CASE("valid JSON is read with full precision") {
  const Json json = parse_json("{\"a\": [1, 0.1, \"x\"], \"b\": {\"a\": 2}}", "t");
  CHECK(json["a"][1].get<double>() == 0.1);
  CHECK(json["b"]["a"] == 2);
}

TEST_CASE("a syntax error says line and column") {
  const auto mistakes = mistakes_of("{\n  \"a\": 1,\n  \"b\": ,\n}");
  REQUIRE(mistakes.size() == 1);
  CHECK(mistakes[0].pointer == "line 3, column 8");
  CHECK(mistakes[0].message.find("json.exception") == std::string::npos);
  CHECK(mistakes[0].message.find("','") != std::string::npos);
}

TEST_CASE("text after the document and an empty document are mistakes") {
  CHECK(mistakes_of("{} {}").size() == 1);
  CHECK(mistakes_of("").size() == 1);
  CHECK(mistakes_of("{\"a\": NaN}").size() == 1);
}

TEST_CASE("nothing behind a zero byte is left out without a word, and UTF-16 is called by its name") {
  const std::string json = "{\"a\": 1}";
  for (const std::string& behind : {std::string("\0", 1), std::string("\0{} nonsense", 12)}) {
    const auto mistakes = mistakes_of(json + behind);
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].message.find("zero byte, byte 9,") != std::string::npos);
  }
  for (const bool little : {true, false}) {
    std::string wide = little ? "\xff\xfe" : "\xfe\xff";
    for (const char c : json) wide += little ? std::string{c, '\0'} : std::string{'\0', c};
    REQUIRE(mistakes_of(wide).size() == 1);
    CHECK(mistakes_of(wide)[0].message.find("is UTF-16") != std::string::npos);
  }
  CHECK(mistakes_of("\xef\xbb\xbf" + json).empty());  // the mark of UTF-8
}

TEST_CASE("text that is no JSON is null for those who can do without") {
  CHECK(json_or_null(R"({"a": 1})").at("a") == 1);
  for (const char* text : {"", "{", R"({"a": 1, "a": 2})", "nan", "{} {}"}) {
    CAPTURE(text);
    CHECK(json_or_null(text).is_null());
  }
}

TEST_CASE("every repeated key is reported with its line, also in nested objects") {
  const auto mistakes =
      mistakes_of("{\"a\": 1,\n \"b\": {\"c\": 1,\n \"c\": 2}, \"d\": [{\"c\": 1}],\n \"a\": 3}");
  REQUIRE(mistakes.size() == 2);
  CHECK(mistakes[0].pointer == "line 3, column 4");
  CHECK(mistakes[0].message.find("\"c\"") != std::string::npos);
  CHECK(mistakes[1].pointer == "line 4, column 4");
  CHECK(mistakes[1].message.find("\"a\"") != std::string::npos);
}

TEST_CASE("the same key in two different objects is no mistake") {
  CHECK(mistakes_of("{\"a\": {\"x\": 1}, \"b\": {\"x\": 1}, \"x\": [{\"x\": 1}, {\"x\": 1}]}").empty());
}

TEST_CASE("a number beyond a double is a mistake with its place") {
  const auto mistakes = mistakes_of("{\"a\": 1,\n\"b\": 1e400}");
  REQUIRE(mistakes.size() == 1);
  CHECK(mistakes[0].pointer.rfind("line 2", 0) == 0);
  CHECK(mistakes[0].message.find("1e400") != std::string::npos);
  CHECK(mistakes_of("{\"b\": 1e308}").empty());
}

TEST_CASE("a pipe is read, and one that nobody writes to is not waited for") {
  const Directory directory;
  const std::string pipe = directory.file("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_WITH(read_json_file(pipe), Catch::Contains("nobody has written"));
  std::thread writer([&] { std::ofstream(pipe) << "{\"a\": 1}"; });
  CHECK(read_json_file(pipe).at("a") == 1);
  writer.join();
}

TEST_CASE("files are replaced whole, and a failure names the file") {
  const Directory dir;
  write_text_file(dir.file("a.json"), "{\"a\": 1}");
  write_text_file(dir.file("a.json"), "{\"a\": 2}");
  CHECK(read_json_file(dir.file("a.json"))["a"] == 2);
  CHECK(std::distance(std::filesystem::directory_iterator(dir.path), {}) == 1);  // no temporary left

  CHECK_THROWS_AS(write_text_file(dir.file("missing/a.json"), "x"), RuntimeError);
  CHECK_THROWS_WITH(write_text_file(dir.file("missing/a.json"), "x"), Catch::Contains("missing/a.json"));
  std::filesystem::create_directories(dir.path / "taken");
  CHECK_THROWS_AS(write_text_file(dir.file("taken"), "x"), RuntimeError);
  CHECK(std::distance(std::filesystem::directory_iterator(dir.path), {}) == 2);
}

TEST_CASE("what cannot be read is an input error that names the file") {
  const Directory dir;
  CHECK_THROWS_AS(read_text_file(dir.file("absent.json")), InputError);
  CHECK_THROWS_WITH(read_json_file(dir.file("absent.json")), Catch::Contains("absent.json"));
  CHECK_THROWS_AS(read_text_file(dir.path.string()), InputError);
  std::ofstream(dir.file("empty")).flush();
  CHECK(read_text_file(dir.file("empty")).empty());
}

TEST_CASE("objects and lists within each other are read to a depth that no stack minds") {
  const auto nested = [](std::size_t levels, const std::string& open, const std::string& close) {
    std::string text;
    for (std::size_t k = 0; k < levels; ++k) text += open;
    text += "1";
    for (std::size_t k = 0; k < levels; ++k) text += close;
    return text;
  };
  CHECK(mistakes_of(nested(most_levels, "[", "]")).empty());
  CHECK(mistakes_of(nested(most_levels, "{\"a\":", "}")).empty());
  for (const auto& text :
       {nested(most_levels + 1, "[", "]"), nested(60000, "[", "]"), nested(40000, "{\"a\":", "}"),
        nested(40000, "[{\"a\":", "}]"), std::string(1000000, '[')}) {
    const auto mistakes = mistakes_of(text);
    REQUIRE(mistakes.size() == 1);
    CHECK_THAT(mistakes[0].message, Catch::Contains("64 deep"));
    CHECK_THAT(mistakes[0].pointer, Catch::StartsWith("line 1, column "));
  }
}

TEST_CASE("a file full of mistakes is told in fifty of them, each short and printable") {
  std::string text = "{";
  for (int k = 0; k < 20000; ++k) text += "\"" + std::string(k % 2 ? 2000 : 1, 'k') + "\": 1, ";
  text += "\"\\u001b[2J\": 1, \"\\u001b[2J\": 2}";
  try {
    parse_json(text, "many.json");
    FAIL("no error");
  } catch (const InputError& error) {
    const std::string words = error.what();
    CHECK(words.size() < 15000);
    CHECK_THAT(words, Catch::Contains("and 50 more"));
    CHECK(error.mistakes().size() == 100);
  }
  CHECK(printable("a\x1b[2J\u009b\u202e\n\tb\x7f") == "a?[2J??\n\tb?");
  CHECK(printable("a\u200eb\u200fc\u061cd") == "a?b?c?d");
  CHECK(printable("\u00e9\u2028 \xff") == "\u00e9\u2028 \xff");
  CHECK(shortened("\u00e9\u00e9", 3) == "\u00e9...");
}

TEST_CASE("a link in the place of a temporary file is not followed") {
  const Directory dir;
  write_text_file(dir.file("victim"), "untouched");
  std::filesystem::create_symlink(dir.file("victim"), dir.file("a.json.tmp" + std::to_string(::getpid())));
  write_text_file(dir.file("a.json"), "new");
  CHECK(read_text_file(dir.file("victim")) == "untouched");
  CHECK(read_text_file(dir.file("a.json")) == "new");
}

TEST_CASE("a look-up by a pointer that is none, or beyond a list, finds nothing") {
  const Json json = parse_json(R"({"a~b": 1, "list": [1, 2]})", "test.json");
  for (const char* pointer :
       {"/a~b", "a", "/list/99999999999999999999", "/list/-", "/list/01", "/list/x", "/~"}) {
    INFO(pointer);
    CHECK(part_at(json, pointer).is_null());
    CHECK(text_at(json, pointer).empty());
    CHECK(std::isnan(number_at(json, pointer)));
  }
  CHECK(number_at(json, "/a~0b") == 1.0);
  CHECK(words_at(parse_json(R"({"c": {"a~b": "x", "n": 7}})", "test.json"), "/c") ==
        std::map<std::string, std::string>{{"a~b", "x"}});
}

TEST_CASE("words of a result that somebody else made command no terminal") {
  const Json json = parse_json(R"({"c": {"/bow/family": "a\u001b[2Jb\u202e", "x\u001b": "y"}})", "test.json");
  CHECK(words_at(json, "/c") == std::map<std::string, std::string>{{"/bow/family", "a?[2Jb?"}, {"x?", "y"}});
}

TEST_CASE("memory and threads that are short are the machine's, and told in words") {
  CHECK(is_of_machine(std::bad_alloc()));
  CHECK_THAT(in_words(std::bad_alloc()), Catch::Contains("not enough memory"));
  const std::system_error threads(std::make_error_code(std::errc::resource_unavailable_try_again));
  CHECK(is_of_machine(threads));
  CHECK_THAT(in_words(threads), Catch::Contains("ulimit -u"));
  CHECK(is_of_machine(RuntimeError("a disk")));
  CHECK_FALSE(is_of_machine(InputError("a mistake")));
  CHECK_FALSE(is_of_machine(std::runtime_error("a crash")));
  try {
    Json::object().at("a");
  } catch (const Json::exception& error) {
    CHECK(in_words(error) == "key 'a' not found");
  }
}

TEST_CASE("a file without end is refused") {
  CHECK_THROWS_WITH(read_text_file("/dev/zero", 1 << 20), Catch::Contains("more than 1048576 bytes"));
}

// The disk that is always full is the system's own; the limit on file sizes stands for a quota.
TEST_CASE("a file that cannot be written whole leaves what was there") {
  const Directory dir;
  write_text_file(dir.file("a"), "old");
  const std::string big(1 << 16, 'x');
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t most : {rlim_t{1}, rlim_t{4096}, rlim_t{(1 << 16) - 1}}) {
    const rlimit limit{most, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    CHECK_THROWS_WITH(write_text_file(dir.file("a"), big), Catch::Contains("File too large"));
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_DFL);
  CHECK(read_text_file(dir.file("a")) == "old");
  CHECK(std::distance(std::filesystem::directory_iterator(dir.path), {}) == 1);
}

TEST_CASE("a decimal comma is told as one") {
  const auto mistakes = mistakes_of("{\"bow\": {\n \"stem_deg\": 24,35, \"x\": 1}}");
  REQUIRE(mistakes.size() == 1);
  CHECK(mistakes[0].message.find("decimal point is wanted: 24.35") != std::string::npos);
  CHECK(mistakes_of("{\"a\": 24, 35}").at(0).message.find("decimal") == std::string::npos);
  CHECK(mistakes_of("[1,2,x]").at(0).message.find("decimal") == std::string::npos);
}
