#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "mesh.h"
#include "scene/geometry.h"
#include "simplify_outline.h"

namespace fe
{
  namespace
  {
    // gmsh is one global library: opened and closed around one mesh.
    struct Session
    {
      Session()
      {
        gmsh::initialize();
        gmsh::option::setNumber("General.Terminal", 0);
      }
      ~Session() { gmsh::finalize(); }
      Session(const Session &) = delete;
      Session &operator=(const Session &) = delete;
    };

    int add_loop(const scene::Polyline &outline, const double size)
    {
      std::vector<int> points, lines;
      for (const Point &p : outline)
        points.push_back(gmsh::model::geo::addPoint(p[0], p[1], 0., size));
      for (std::size_t k = 0; k < points.size(); ++k)
        lines.push_back(gmsh::model::geo::addLine(points[k], points[(k + 1) % points.size()]));
      return gmsh::model::geo::addCurveLoop(lines);
    }

    // A vertex at p where p lies on a side of the outline, unless one is there already.
    void insert(scene::Polyline &outline, const Point &p, const double tolerance)
    {
      for (std::size_t k = 0; k < outline.size(); ++k)
      {
        const Point &a = outline[k], along = outline[(k + 1) % outline.size()] - a;
        const double length = along.norm(), s = (p - a).dot(along) / length;
        const double aside = std::abs(along[0] * (p - a)[1] - along[1] * (p - a)[0]) / length;
        if (aside > 1e-3 * tolerance || s < tolerance || s > length - tolerance)
          continue;
        outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(k) + 1, p);
        return;
      }
    }

    bool inside(const scene::Polyline &outline, const Point &p)
    {
      bool in = false;
      for (std::size_t k = 0, j = outline.size() - 1; k < outline.size(); j = k++)
        if ((outline[k][1] > p[1]) != (outline[j][1] > p[1]) &&
            p[0] < outline[k][0] + (outline[j][0] - outline[k][0]) * (p[1] - outline[k][1]) /
                                       (outline[j][1] - outline[k][1]))
          in = !in;
      return in;
    }

    // Outer outlines run counter-clockwise; each clockwise one is a hole of the smallest outer one
    // around it.
    void add_surfaces(const std::vector<scene::Polyline> &outlines, const double size)
    {
      std::map<std::size_t, std::vector<int>> surfaces;
      for (std::size_t k = 0; k < outlines.size(); ++k)
        if (scene::signed_area(outlines[k]) > 0.)
          surfaces[k].push_back(add_loop(outlines[k], size));
      for (const scene::Polyline &hole : outlines)
      {
        if (scene::signed_area(hole) >= 0.)
          continue;
        double smallest = HUGE_VAL;
        std::vector<int> *owner = nullptr;
        for (auto &[k, loops] : surfaces)
          if (inside(outlines[k], hole.front()) && scene::signed_area(outlines[k]) < smallest)
          {
            smallest = scene::signed_area(outlines[k]);
            owner = &loops;
          }
        if (owner)
          owner->push_back(add_loop(hole, size));
      }
      for (const auto &[k, loops] : surfaces)
        gmsh::model::geo::addPlaneSurface(loops);
    }

    QuadMesh collect()
    {
      std::vector<std::size_t> tags;
      std::vector<double> coordinates, parametric;
      gmsh::model::mesh::getNodes(tags, coordinates, parametric);
      std::map<std::size_t, Point> position;
      for (std::size_t k = 0; k < tags.size(); ++k)
        position[tags[k]] = Point(coordinates[3 * k], coordinates[3 * k + 1]);

      std::vector<int> types;
      std::vector<std::vector<std::size_t>> elements, nodes;
      gmsh::model::mesh::getElements(types, elements, nodes, 2);
      constexpr int quadrilateral = 3; // gmsh's number of the four-node element
      QuadMesh mesh;
      std::map<std::size_t, int> number;
      for (std::size_t t = 0; t < types.size(); ++t)
      {
        if (types[t] != quadrilateral)
          throw std::runtime_error("gmsh left elements that are not quadrilaterals; ask for "
                                   "smaller cells in [fe] cells");
        for (std::size_t k = 0; k < nodes[t].size(); k += 4)
        {
          std::array<int, 4> cell{};
          scene::Polyline corners;
          for (int c = 0; c < 4; ++c)
          {
            const std::size_t tag = nodes[t][k + c];
            const auto [entry, fresh] = number.emplace(tag, static_cast<int>(mesh.vertices.size()));
            if (fresh)
              mesh.vertices.push_back(position.at(tag));
            cell[c] = entry->second;
            corners.push_back(position.at(tag));
          }
          if (scene::signed_area(corners) < 0.)
            std::swap(cell[1], cell[3]);
          mesh.cells.push_back(cell);
        }
      }
      return mesh;
    }
  } // namespace

  QuadMesh mesh_outline(const std::vector<scene::Body> &bodies, const scene::Domain &domain,
                        const Point &spacing, const std::vector<Point> &ends)
  {
    const double size = std::min(spacing[0], spacing[1]);
    // Subdivision halves every element: the triangles before it are twice the wanted size.
    std::vector<scene::Polyline> outlines = scene::outline(bodies, domain, 0.5 * size);
    for (scene::Polyline &outline : outlines)
    {
      outline = simplify_outline(outline, 0.02 * size, 0.5 * size);
      for (const Point &end : ends)
        insert(outline, end, 1e-3 * size);
    }
    const Session session;
    gmsh::model::add("outline");
    add_surfaces(outlines, 2. * size);
    gmsh::model::geo::synchronize();
    gmsh::option::setNumber("Mesh.MeshSizeMax", 2. * size);
    gmsh::option::setNumber("Mesh.Algorithm", 6); // frontal-Delaunay; 8 crashes in Gmsh 4.8
    gmsh::option::setNumber("Mesh.RecombineAll", 1);
    gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1); // leave quadrilaterals only
    gmsh::option::setNumber("Mesh.RandomSeed", 1);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::model::mesh::generate(2);
    QuadMesh mesh = collect();
    if (mesh.cells.empty())
      throw std::runtime_error("gmsh made no mesh of the bodies; is their outline closed?");
    return mesh;
  }
} // namespace fe
