// The result store of a study: DIR/results.sqlite, written by one process. What it acknowledged survives a
// kill.
//
// Each row carries a digest of its content. One that does not fit it, or cannot be read, is told as an
// evaluation of status `damaged` and costs no other row.
//
// Rows are kept by key for as long as the file lives, so going back to an earlier version of a study file
// finds its results. begin_study() says which of them belong to the study as it stands now.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/evaluate/evaluation.h"

namespace icebow {

enum class Journal {
  automatic,  // WAL on a local disk, rollback on a network file system
  rollback    // readers and the writer wait for each other, but it works everywhere
};

class Store {
 public:
  // Asked some fifty times a second while a program that is not icebow holds the file locked, with the
  // seconds that it has been waited for; false gives up. Must not throw.
  using Waiting = std::function<bool(double seconds)>;

  // Creates the file where there is none, and holds `path`.lock until it is closed: a second writer is
  // refused. A store of an earlier version is brought to this one. Throws RuntimeError naming the file
  // (locked, full, not a store, its pages damaged). Without `waiting`, 20 s are waited for others.
  static Store open(const std::string& path, Journal journal = Journal::automatic, Waiting waiting = {});
  // For readers, at any time, while a run writes too. Throws likewise.
  static Store open_read_only(const std::string& path);
  Store(Store&&) noexcept;
  ~Store();

  std::optional<Evaluation> find(const std::string& key) const;
  std::optional<Evaluation> find_name(const std::string& name) const;
  void put(const Evaluation& evaluation);  // inserts or replaces by key
  // What `work` puts and removes becomes safe together, at its end: one commit instead of many. Where `work`
  // throws, what it had done until then is kept.
  void together(const std::function<void()>& work);
  void remove(const std::string& key);
  void remove_damaged();  // the rows; their designs are then as if they had never been evaluated

  // The evaluations of the present study, in its order, then rows that are damaged: whose they were cannot be
  // known. Where no study was begun, every evaluation, in the order they were first put. Throws RuntimeError
  // where the study's list of designs is damaged.
  std::vector<Evaluation> all() const;
  std::vector<Evaluation> everything()
      const;  // those of earlier versions of the study file too, as first put

  // Keys of the present study, in its order. They need not have been evaluated yet.
  void begin_study(const std::vector<std::string>& keys);
  void add_to_study(const std::string& key);
  int designs() const;  // how many keys the present study has so far

  // Study-level facts: "study" (the document), "command", "version", "host", "started", "seed" ...
  void set_fact(const std::string& name, const std::string& value);
  std::string fact(const std::string& name) const;  // empty where unknown; throws RuntimeError where damaged
  std::string fact_or_nothing(const std::string& name) const;  // empty where damaged too

 private:
  struct Impl;
  explicit Store(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace icebow
