// The result store of a study: DIR/results.sqlite, written by one process. What it acknowledged survives a kill.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/evaluation.h"

namespace icebow {

class Store {
 public:
  // Creates the file where there is none. Throws RuntimeError naming the file (locked, full, not a store).
  static Store open(const std::string& path);
  static Store open_read_only(const std::string& path);
  Store(Store&&) noexcept;
  ~Store();

  std::optional<Evaluation> find(const std::string& key) const;
  void put(const Evaluation& evaluation);  // inserts or replaces by key
  std::vector<Evaluation> all() const;     // in the order they were first put

  // Study-level facts: "study" (the document), "command", "version", "host", "started", "seed" ...
  void set_fact(const std::string& name, const std::string& value);
  std::string fact(const std::string& name) const;  // empty where unknown

 private:
  struct Impl;
  explicit Store(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace icebow
