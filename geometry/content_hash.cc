// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/content_hash.h"
#include <cstddef>
#include <span>

namespace ballonet::geometry
{

namespace
{

class Fnv
{
public:
  void add(std::span<const std::byte> bytes)
  {
    for (const std::byte byte : bytes)
      value_ = (value_ ^ static_cast<std::uint64_t>(byte)) * prime;
  }
  /// A list with its length, so that neighbouring lists cannot be exchanged for one another.
  template <class T>
  void add_list(std::span<const T> list)
  {
    const std::uint64_t size = list.size();
    add(std::as_bytes(std::span(&size, 1)));
    add(std::as_bytes(list));
  }
  std::uint64_t value() const { return value_; }

private:
  static constexpr std::uint64_t prime = 1099511628211ULL;
  std::uint64_t value_ = 14695981039346656037ULL;
};

} // namespace

std::uint64_t content_hash(const Mesh &mesh)
{
  Fnv hash;
  hash.add_list(std::span(mesh.nodes));
  hash.add_list(std::span(mesh.cells));
  hash.add_list(std::span(mesh.cell_body));
  for (const Body &body : mesh.bodies)
    hash.add_list(std::span(body.name));
  for (const Surface &surface : mesh.surfaces) {
    hash.add_list(std::span(surface.name));
    hash.add_list(std::span(surface.faces));
  }
  for (const NodeSet &set : mesh.node_sets) {
    hash.add_list(std::span(set.name));
    hash.add_list(std::span(set.nodes));
  }
  return hash.value();
}

} // namespace ballonet::geometry
