#include "mesh.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry.h"
#include "scene/reader.h"

namespace fe
{
  namespace
  {
    bool only_rectangles(const std::vector<scene::Body> &bodies)
    {
      return std::all_of(bodies.begin(), bodies.end(),
                         [](const scene::Body &body)
                         { return std::holds_alternative<scene::Rectangle>(body.shape); });
    }

    // Pieces that touch in an edge are one; a piece without support has no equilibrium.
    std::vector<int> pieces_of(const QuadMesh &mesh)
    {
      std::vector<int> piece(mesh.vertices.size());
      for (std::size_t i = 0; i < piece.size(); ++i)
        piece[i] = static_cast<int>(i);
      const auto root = [&piece](int i)
      {
        while (piece[i] != i)
          i = piece[i] = piece[piece[i]];
        return i;
      };
      for (const auto &cell : mesh.cells)
        for (int k = 1; k < 4; ++k)
          piece[root(cell[k])] = root(cell[0]);
      for (std::size_t i = 0; i < piece.size(); ++i)
        piece[i] = root(static_cast<int>(i));
      return piece;
    }

    void check_pieces(const scene::Scene &scene, const QuadMesh &mesh)
    {
      const std::vector<int> piece = pieces_of(mesh);
      const scene::Box box = scene::bounding_box(scene.bodies);
      const double tolerance = 1e-9 * (box.upper - box.lower).norm();
      std::vector<char> held(mesh.vertices.size(), 0);
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (const scene::Support &support : scene.supports)
          if (scene::contains(support.where, box, mesh.vertices[i], tolerance))
            held[piece[i]] = 1;
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (!held[piece[i]])
        {
          const Point &p = mesh.vertices[i];
          const scene::Place &place = scene.bodies.front().place;
          throw scene::BadScene(
              place.file + ":" + std::to_string(place.line) + ": body: the material near (" +
              std::to_string(p[0]) + ", " + std::to_string(p[1]) +
              ") touches no [[support]]; without inertia it has no equilibrium. Hold it with a "
              "support, or run this scene with mpm_pf alone");
        }
    }
  } // namespace

  std::array<int, 2> wanted_cells(const scene::Scene &scene)
  {
    const std::array<int, 2> asked = scene.fe ? scene.fe->cells : std::array<int, 2>{0, 0};
    const scene::Box box = scene::bounding_box(scene.bodies);
    std::array<int, 2> cells{};
    for (int d = 0; d < 2; ++d)
      cells[d] = asked[d] > 0
                     ? asked[d]
                     : std::max(1, static_cast<int>(std::lround((box.upper[d] - box.lower[d]) /
                                                                scene.domain.spacing()[d])));
    return cells;
  }

  QuadMesh make_mesh(const scene::Scene &scene)
  {
    const std::array<int, 2> cells = wanted_cells(scene);
    const scene::Box box = scene::bounding_box(scene.bodies);
    const Point size = box.upper - box.lower;
    const double grading = scene.fe ? scene.fe->grading : 0.;
    QuadMesh mesh = only_rectangles(scene.bodies)
                        ? mesh_rectangles(scene.bodies, cells, grading, scene.supports)
                        : mesh_outline(scene.bodies, {size[0] / cells[0], size[1] / cells[1]});
    check_pieces(scene, mesh);
    return mesh;
  }
} // namespace fe
