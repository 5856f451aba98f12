#include "hullgen/mesh/mesh_repairs.h"

#include "base/text.h"

namespace icebow {

std::vector<std::string> in_words(const MeshRepairs& r) {
  std::vector<std::string> words;
  const auto say = [&](int n, const char* one, const char* many) {
    if (n > 0) words.push_back(text(n == 1 ? one : many, n));
  };
  say(r.mirrored, "%d panel was mirrored to the other side", "%d panels were mirrored to the other side");
  say(r.split, "%d panel was split into triangles", "%d panels were split into triangles");
  say(r.joined, "%d point was joined to one in the same place",
      "%d points were joined to others in the same place");
  say(r.collapsed, "%d panel without area was dropped", "%d panels without area were dropped");
  say(r.repeated, "%d panel that was there twice was dropped",
      "%d panels that were there twice were dropped");
  say(r.walls, "%d panel between two bodies that touch was dropped",
      "%d panels between bodies that touch were dropped");
  say(r.inserted, "%d point was put into the edge of the panel beside it (T-junction)",
      "%d points were put into the edges of the panels beside them (T-junctions)");
  if (r.gaps > 0)
    words.push_back(text("%d %s joined across gaps of up to %.2g mm", r.gaps,
                         r.gaps == 1 ? "point was" : "points were", 1e3 * r.gap));
  if (r.moved_to_centre > 0)
    words.push_back(text("%d %s moved onto the centre plane, by up to %.2g mm", r.moved_to_centre,
                         r.moved_to_centre == 1 ? "point was" : "points were", 1e3 * r.off_centre));
  say(r.turned, "%d panel was turned outward", "%d panels were turned outward");
  words.insert(words.end(), r.notes.begin(), r.notes.end());
  if (r.components > 1) words.push_back(text("it consists of %d closed surfaces", r.components));
  return words;
}

}  // namespace icebow
