#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "follow_outline.h"
#include "mesh.h"
#include "scene/geometry.h"
#include "scene/reader.h"
#include "simplify_outline.h"
#include "support_lines.h"

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
        gmsh::option::setNumber("General.ExpertMode", 1); // ask nothing: nobody may be there
      }
      ~Session() { gmsh::finalize(); }
      Session(const Session &) = delete;
      Session &operator=(const Session &) = delete;
    };

    // Points by their places: a line that ends on an outline shares the vertex there.
    struct Places
    {
      double size, tolerance;
      std::vector<std::pair<Point, int>> known = {};

      int at(const Point &p)
      {
        for (const auto &[place, tag] : known)
          if ((place - p).norm() < tolerance)
            return tag;
        known.emplace_back(p, gmsh::model::geo::addPoint(p[0], p[1], 0., size));
        return known.back().second;
      }
    };

    int add_loop(const scene::Polyline &outline, Places &places)
    {
      std::vector<int> points, lines;
      for (const Point &p : outline)
      {
        points.push_back(gmsh::model::geo::addPoint(p[0], p[1], 0., places.size));
        places.known.emplace_back(p, points.back());
      }
      for (std::size_t k = 0; k < points.size(); ++k)
        lines.push_back(gmsh::model::geo::addLine(points[k], points[(k + 1) % points.size()]));
      return gmsh::model::geo::addCurveLoop(lines);
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
    // Returns the surfaces by the outlines around them.
    std::map<std::size_t, int> add_surfaces(const std::vector<scene::Polyline> &outlines,
                                            Places &places)
    {
      std::map<std::size_t, std::vector<int>> surfaces;
      for (std::size_t k = 0; k < outlines.size(); ++k)
        if (scene::signed_area(outlines[k]) > 0.)
          surfaces[k].push_back(add_loop(outlines[k], places));
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
          owner->push_back(add_loop(hole, places));
      }
      std::map<std::size_t, int> tags;
      for (const auto &[k, loops] : surfaces)
        tags[k] = gmsh::model::geo::addPlaneSurface(loops);
      return tags;
    }

    using Line = std::array<Point, 2>;

    void embed(const std::vector<Line> &held, const std::vector<scene::Polyline> &outlines,
               const std::map<std::size_t, int> &surfaces, Places &places)
    {
      std::map<int, std::vector<int>> lines;
      for (const Line &line : held)
      {
        const Point middle = 0.5 * (line[0] + line[1]);
        double smallest = HUGE_VAL;
        int surface = -1;
        for (const auto &[k, tag] : surfaces)
          if (inside(outlines[k], middle) && scene::signed_area(outlines[k]) < smallest)
            smallest = scene::signed_area(outlines[k]), surface = tag;
        const int a = places.at(line[0]), b = places.at(line[1]);
        if (surface >= 0 && a != b)
          lines[surface].push_back(gmsh::model::geo::addLine(a, b));
      }
      gmsh::model::geo::synchronize();
      for (const auto &[surface, tags] : lines)
        gmsh::model::mesh::embed(1, tags, 2, surface);
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

    // As segments as long as the bodies.
    std::vector<scene::Where> symmetry_sides(const scene::Domain &domain, const scene::Box &box)
    {
      std::vector<scene::Where> sides;
      for (int side = 0; side < 4; ++side)
      {
        if (domain.boundary[side] != scene::Boundary::symmetry)
          continue;
        const int axis = side / 2;
        scene::Segment segment{box.lower, box.upper};
        segment.a[axis] = segment.b[axis] = (side % 2 ? domain.upper() : domain.lower)[axis];
        sides.push_back(segment);
      }
      return sides;
    }

    [[noreturn]] void refuse_crossing(const scene::SourceLocation &place)
    {
      throw scene::BadScene(place.file + ":" + std::to_string(place.line) +
                            ": body: the bodies' outline crosses or touches itself and cannot be "
                            "meshed\n  remedy: mend the outline; with coarse [fe] cells across a "
                            "narrow gap, finer ones");
    }
  } // namespace

  QuadMesh mesh_outline(const std::vector<scene::Body> &bodies, const scene::Domain &domain,
                        const Point &spacing, const std::vector<scene::Where> &parts,
                        const std::vector<scene::Support> &held)
  {
    const double size = std::min(spacing[0], spacing[1]);
    const scene::Box box = scene::bounding_box(bodies);
    const double tolerance = matching_tolerance(box);
    std::vector<scene::Where> held_or_loaded = symmetry_sides(domain, box);
    held_or_loaded.insert(held_or_loaded.end(), parts.begin(), parts.end());
    std::vector<scene::Polyline> exact = scene::outline(bodies, domain, 0.1 * size), outlines;
    for (scene::Polyline &outline : exact)
    {
      outline = with_ends(outline, held_or_loaded, {tolerance, tolerance});
      const std::vector<char> ends = ends_of_parts(outline, size, held_or_loaded, box, tolerance);
      outlines.push_back(simplify_outline(outline, ends, {0.02 * size, 0.5 * size}));
      if (scene::crosses_itself(outlines.back())) // what gmsh then throws cannot be caught
        refuse_crossing(bodies.front().place);
    }
    const Session session;
    gmsh::model::add("outline");
    // Subdivision halves every element: the triangles before it are twice the wanted size.
    Places places{2. * size, 0.06 * size};
    const auto surfaces = add_surfaces(outlines, places);
    embed(held_lines_inside(bodies, domain, outlines, held, 0.05 * size), outlines, surfaces,
          places);
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
    follow_outline(mesh, exact, 0.1 * size);
    return mesh;
  }
} // namespace fe
