#include <algorithm>
#include <cstring>
#include <unordered_map>

#include "base/collective.h"
#include "geometry/union_find.h"
#include "solver/ice/local_bonds.h"
#include "solver/ice/local_cloud.h"

namespace icebow {
namespace {

// What one rank knows of a piece. `label` is the smallest id the rank sees in it.
struct Share {
  std::int64_t label, size;  // own particles
  std::int64_t standing;     // 1 = tied to a held edge
};

// A particle that two ranks see, and the label it has on one of them.
struct Tie {
  std::int64_t id, label;
};

struct Numbered {
  std::int64_t label, number;
};

// This rank's pieces, cut at its borders.
class OwnPieces {
 public:
  explicit OwnPieces(const IceSheet& sheet) : sheet_(sheet), near_(sheet), set_(near_.size()) {
    near_.for_each_bond([this](std::int32_t a, std::int32_t b, bool alive) {
      if (alive) set_.join(a, b);
    });
  }

  std::vector<Tie> ties() {
    std::vector<Tie> list;
    const Layout& l = sheet_.layout;
    for (int jl = -reach; jl < l.columns + reach; ++jl) {
      for (int k = 0; k < l.nz; ++k) {
        for (int il = -reach; il < l.blocks * block + reach; ++il) {
          if (!near_.exists(jl, il) || near_.image(jl) || (near_.own(jl, il) && !near_.shared(jl, il)))
            continue;
          for (int side = 0; side < near_.sides(); ++side) {
            const std::int32_t n = near_.number(jl, k, il, side), root = set_.find(n);
            if (root != n) list.push_back({near_.id(n), near_.id(root)});
          }
        }
      }
    }
    return list;
  }

  // The pieces that may get a number: they reach the border, stand, are large, or are the largest.
  std::vector<Share> shares(std::int64_t floe_size) {
    struct Count {
      std::int64_t size = 0;
      bool standing = false, shared = false;
    };
    std::vector<Count> counts(near_.size());
    near_.for_each_own([&](int jl, int k, int il) {
      for (int side = 0; side < near_.sides(); ++side) {
        Count& c = counts[set_.find(near_.number(jl, k, il, side))];
        ++c.size;
        c.standing = c.standing || sheet_.held(sheet_.layout.i0 + il, sheet_.layout.j0 + jl);
        c.shared = c.shared || near_.shared(jl, il);
      }
    });
    const auto largest = std::max_element(counts.begin(), counts.end(),
                                          [](const Count& a, const Count& b) { return a.size < b.size; });
    std::vector<Share> list;
    for (auto c = counts.begin(); c != counts.end(); ++c) {
      if (c->size == 0 || !(c->shared || c->standing || c->size >= floe_size || c == largest)) continue;
      list.push_back({near_.id(static_cast<std::int32_t>(c - counts.begin())), c->size, c->standing});
    }
    return list;
  }

  // Crushed (-1) unless listed.
  std::vector<std::int32_t> numbers(const std::vector<Numbered>& list) {
    std::unordered_map<std::int64_t, std::int32_t> number;
    for (const Numbered& n : list) number[n.label] = static_cast<std::int32_t>(n.number);
    std::vector<std::int32_t> of_root(near_.size(), -2), result;
    for (int side = 0; side < near_.sides(); ++side) {
      near_.for_each_own([&](int jl, int k, int il) {
        const std::int32_t root = set_.find(near_.number(jl, k, il, side));
        if (of_root[root] == -2) {
          const auto found = number.find(near_.id(root));
          of_root[root] = found == number.end() ? -1 : found->second;
        }
        result.push_back(of_root[root]);
      });
    }
    return result;
  }

 private:
  const IceSheet& sheet_;
  NearbyParticles near_;
  UnionFind set_;
};

// The sheet's pieces out of the ranks' shares, on the root.
class WholePieces {
 public:
  void tie(const Tie& t) {
    const std::int64_t a = find(t.id), b = find(t.label);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }
  void add(const Share& share) {
    Share& whole = whole_.try_emplace(find(share.label), Share{find(share.label), 0, 0}).first->second;
    whole.size += share.size;
    whole.standing |= share.standing;
  }
  // The labels of the shares with the numbers of their pieces, those with a number only: 0 stands, floes by
  // size.
  std::vector<Numbered> number(const std::vector<Share>& shares, std::int64_t floe_size) {
    std::vector<Share> order;
    bool any_standing = false;
    for (const auto& [label, share] : whole_) {
      order.push_back(share);
      any_standing = any_standing || share.standing;
    }
    std::sort(order.begin(), order.end(), [](const Share& a, const Share& b) {
      return a.size != b.size ? a.size > b.size : a.label < b.label;
    });
    if (!any_standing && !order.empty()) order.front().standing = 1;
    std::unordered_map<std::int64_t, std::int64_t> number;
    std::int64_t floes = 0;
    for (const Share& share : order) {
      if (share.standing) {
        number[share.label] = 0;
      } else if (share.size >= floe_size) {
        number[share.label] = ++floes;
      }
    }
    std::vector<Numbered> list;
    for (const Share& share : shares) {
      const auto found = number.find(find(share.label));
      if (found != number.end()) list.push_back({share.label, found->second});
    }
    return list;
  }

 private:
  std::int64_t find(std::int64_t id) {
    for (auto up = parent_.find(id); up != parent_.end(); up = parent_.find(id)) id = up->second;
    return id;
  }
  std::unordered_map<std::int64_t, std::int64_t> parent_;  // absent: stands for itself
  std::unordered_map<std::int64_t, Share> whole_;
};

}  // namespace

std::vector<std::int32_t> local_pieces(const Communicator& comm, const IceSheet& sheet) {
  const std::int64_t nz = sheet.lattice.nz, floe_size = 4 * nz * nz * nz;
  OwnPieces own(sheet);
  const std::vector<Tie> ties = gather(comm, own.ties());
  const std::vector<Share> shares = gather(comm, own.shares(floe_size));
  std::vector<Numbered> numbered;
  if (comm.is_root()) {
    WholePieces whole;
    for (const Tie& tie : ties) whole.tie(tie);
    for (const Share& share : shares) whole.add(share);
    numbered = whole.number(shares, floe_size);
  }
  broadcast(comm, numbered);
  return own.numbers(numbered);
}

}  // namespace icebow
