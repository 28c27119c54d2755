// State of an extension to and from a checkpoint.
#include <stdexcept>
#include <type_traits>

#include "medium/contour_tiles.h"
#include "medium/extension.h"

namespace medium
{
  namespace
  {
    constexpr auto other_mesh = "the checkpoint's extension is that of another mesh";

    /// Calls visit(number) for every node of the distance's three fields; one list serves both
    /// directions.
    template <class D, class Visit>
    void for_each_number(D &distance, const Mesh &mesh, const Visit &visit)
    {
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          visit(distance.psi(i, j)), visit(distance.piece(i, j)), visit(distance.offset(i, j));
    }
  } // namespace

  std::vector<double> pack(const Extension &extension, const Mesh &mesh)
  {
    std::vector<double> state{static_cast<double>(extension.calls)};
    if (extension.calls == 0)
      return state;
    for (int j = 0; j < mesh.nodes[1]; ++j)
      state.insert(state.end(), extension.nearest_piece.row(j),
                   extension.nearest_piece.row(j) + mesh.nodes[0]);
    for (const Point &place : extension.mapped_pieces)
      state.insert(state.end(), {place[0], place[1]});
    return state;
  }

  void unpack(Extension &extension, const Mesh &mesh, const std::vector<double> &state)
  {
    extension.calls = static_cast<long>(state.at(0));
    extension.mapped_pieces.clear();
    if (extension.calls == 0)
      return;
    const std::size_t places = 1 + static_cast<std::size_t>(mesh.nodes[0]) * mesh.nodes[1];
    if (state.size() < places || (state.size() - places) % 2 != 0)
      throw std::runtime_error(other_mesh);
    auto next = state.begin() + 1;
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        extension.nearest_piece(i, j) = static_cast<int>(*next++);
    for (; next != state.end(); next += 2)
      extension.mapped_pieces.emplace_back(next[0], next[1]);
  }

  std::vector<double> pack_distance(const Extension &extension, const Mesh &mesh)
  {
    std::vector<double> state{static_cast<double>(extension.since_measured)};
    if (extension.calls == 0)
      return state;
    for_each_number(extension.distance, mesh,
                    [&](const auto number) { state.push_back(static_cast<double>(number)); });
    for (const ContourPiece &piece : extension.distance.pieces)
      state.insert(state.end(),
                   {piece.x, piece.y, piece.normal_x, piece.normal_y, piece.curvature});
    return state;
  }

  void unpack_distance(Extension &extension, const Mesh &mesh, const std::vector<double> &state)
  {
    extension.since_measured = static_cast<int>(state.at(0));
    Distance &distance = extension.distance;
    distance.pieces.clear();
    if (state.size() == 1)
      return;
    const std::size_t fields = 1 + 3 * static_cast<std::size_t>(mesh.nodes[0]) * mesh.nodes[1];
    if (state.size() < fields || (state.size() - fields) % 5 != 0)
      throw std::runtime_error(other_mesh);
    auto next = state.begin() + 1;
    for_each_number(distance, mesh,
                    [&](auto &number)
                    { number = static_cast<std::decay_t<decltype(number)>>(*next++); });
    for (; next != state.end(); next += 5)
      distance.pieces.push_back({next[0], next[1], next[2], next[3], next[4]});
    mark_tiles(distance, mesh);
  }
} // namespace medium
