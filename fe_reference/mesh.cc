#include "mesh.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pieces.h"
#include "record/provenance.h"
#include "scene/geometry.h"
#include "scene/reader.h"
#include "scene/value.h"

namespace fe
{
  bool are_all_rectangles(const std::vector<scene::Body> &bodies)
  {
    return std::all_of(bodies.begin(), bodies.end(),
                       [](const scene::Body &body)
                       { return std::holds_alternative<scene::Rectangle>(body.shape); });
  }

  namespace
  {
    bool is_symmetry(const scene::Domain &domain, const int axis, const bool upper)
    {
      return domain.boundary[2 * axis + upper] == scene::Boundary::symmetry;
    }

    // Smallest box around what is left of the bodies within the symmetry sides.
    scene::Box cut_box(const scene::Scene &scene)
    {
      scene::Box box = scene::bounding_box(scene.bodies);
      for (int axis = 0; axis < 2; ++axis)
      {
        if (is_symmetry(scene.domain, axis, false))
          box.lower[axis] = std::max(box.lower[axis], scene.domain.lower[axis]);
        if (is_symmetry(scene.domain, axis, true))
          box.upper[axis] = std::min(box.upper[axis], scene.domain.upper()[axis]);
      }
      return box;
    }

    // Rectangles without what lies beyond the symmetry sides of the domain.
    std::vector<scene::Body> cut(std::vector<scene::Body> bodies, const scene::Domain &domain)
    {
      for (scene::Body &body : bodies)
      {
        auto &rectangle = std::get<scene::Rectangle>(body.shape);
        Point lower = rectangle.corner, upper = rectangle.corner + rectangle.size;
        for (int axis = 0; axis < 2; ++axis)
        {
          if (is_symmetry(domain, axis, false))
            lower[axis] = std::max(lower[axis], domain.lower[axis]);
          if (is_symmetry(domain, axis, true))
            upper[axis] = std::min(upper[axis], domain.upper()[axis]);
        }
        rectangle = {lower, upper - lower};
      }
      return bodies;
    }

    double area_within(const scene::Scene &scene, const double spacing)
    {
      double area = 0.;
      for (const auto &line : scene::outline(scene.bodies, scene.domain, spacing))
        area += scene::signed_area(line);
      return area;
    }

    // Before the mesh eats what there is: no cell gets by with less than 5 kB, a quadratic one
    // takes 30 kB with its part of the factors.
    void refuse_more_than_memory(const scene::Scene &scene, const std::array<int, 2> &cells)
    {
      constexpr double least_bytes = 5e3;
      const scene::Box box = cut_box(scene);
      const double area = area_within(scene, (box.upper - box.lower).norm() / 50.);
      const double bytes =
          least_bytes * cells[0] * cells[1] * area / (box.upper - box.lower).prod();
      const double has = record::machine_bytes();
      if (bytes <= has)
        return;
      const bool asked = scene.fe && scene.fe->cells[0] > 0;
      const scene::SourceLocation &place = asked ? scene.fe->place : scene.domain.place;
      std::ostringstream text;
      text.precision(3);
      text << place.file << ":" << place.line << ": " << (asked ? "fe.cells" : "domain.cells")
           << ": " << cells[0] << " x " << cells[1] << " elements over the bodies take at least "
           << bytes / 1e9 << " GB; this machine has " << has / 1e9
           << " GB\n  remedy: fewer fe.cells (absent, they are as fine as domain.cells)";
      throw scene::BadScene(text.str());
    }

    // What is held or loaded.
    std::vector<scene::Where> parts_of(const scene::Scene &scene)
    {
      std::vector<scene::Where> parts;
      for (const scene::Support &support : scene.supports)
        parts.push_back(support.where);
      for (const scene::Traction &traction : scene.tractions)
        parts.push_back(traction.where);
      return parts;
    }

    // A piece without support has no equilibrium.
    void check_pieces(const scene::Scene &scene, const QuadMesh &mesh)
    {
      std::vector<int> cell_vertices;
      for (const auto &cell : mesh.cells)
        cell_vertices.insert(cell_vertices.end(), cell.begin(), cell.end());
      const std::vector<int> piece =
          connected_pieces(static_cast<int>(mesh.vertices.size()), cell_vertices, 4);
      const scene::Box box = scene::bounding_box(scene.bodies);
      const double tolerance = matching_tolerance(box);
      std::vector<char> held(mesh.vertices.size(), 0);
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (const scene::Support &support : scene.supports)
          if (scene::contains(support.where, box, mesh.vertices[i], tolerance))
            held[piece[i]] = 1;
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (int axis = 0; axis < 2; ++axis)
          if (on_symmetry_side(scene.domain, axis, mesh.vertices[i], tolerance))
            held[piece[i]] = 1;
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (!held[piece[i]])
        {
          const Point &p = mesh.vertices[i];
          const scene::SourceLocation &place = scene.bodies.front().place;
          throw scene::BadScene(
              place.file + ":" + std::to_string(place.line) + ": body: the material near (" +
              scene::number_text(p[0]) + ", " + scene::number_text(p[1]) +
              ") touches no [[support]]; without inertia it has no equilibrium. Hold it with a "
              "support, or run this scene with mpm_pf alone");
        }
    }
  } // namespace

  double matching_tolerance(const scene::Box &bodies)
  {
    return 1e-7 * (bodies.upper - bodies.lower).norm();
  }

  double filled_fraction(const scene::Scene &scene, const QuadMesh &mesh)
  {
    double area = 0.;
    for (const auto &cell : mesh.cells)
      area += scene::signed_area({mesh.vertices[cell[0]], mesh.vertices[cell[1]],
                                  mesh.vertices[cell[2]], mesh.vertices[cell[3]]});
    const scene::Box box = cut_box(scene);
    return area / area_within(scene, (box.upper - box.lower).norm() / 2000.);
  }

  std::array<int, 2> wanted_cells(const scene::Scene &scene)
  {
    const std::array<int, 2> asked = scene.fe ? scene.fe->cells : std::array<int, 2>{0, 0};
    const scene::Box box = cut_box(scene);
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
    refuse_more_than_memory(scene, cells);
    const scene::Box box = cut_box(scene);
    const Point size = box.upper - box.lower;
    const double grading = scene.fe ? scene.fe->grading : 0.;
    const std::vector<scene::Where> parts = parts_of(scene);
    QuadMesh mesh =
        are_all_rectangles(scene.bodies)
            ? mesh_rectangles(cut(scene.bodies, scene.domain), cells, grading, scene.supports,
                              parts)
            : mesh_outline(scene.bodies, scene.domain, {size[0] / cells[0], size[1] / cells[1]},
                           parts, scene.supports);
    check_pieces(scene, mesh);
    return mesh;
  }
} // namespace fe
