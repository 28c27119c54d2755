#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "patches.h"

namespace fe
{
  namespace
  {
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();

    std::vector<Quantity> functions(const std::vector<std::string> &names)
    {
      std::vector<Quantity> result;
      for (const std::string &name : names)
        result.push_back(quantity(name));
      return result;
    }

    Point interpolate(const Snapshot &body, const Location &at, const std::vector<double> &field)
    {
      const Discretisation &d = body.problem.mesh;
      std::array<double, 9> value{};
      shape_functions(d.degree, d.unit_node, at.unit, value.data(), nullptr);
      Point result = Point::Zero();
      for (int a = 0; a < d.nodes_per_cell; ++a)
      {
        const int n = d.nodes_of(at.cell)[a];
        result += value[a] * Point(field[2 * n], field[2 * n + 1]);
      }
      return result;
    }

    Sample sample_at(const Snapshot &body, const Location &at, const int point, const double area)
    {
      return {body.points.data() + at.cell * body.problem.mesh.points_per_cell + point,
              interpolate(body, at, body.u), interpolate(body, at, body.velocity), area};
    }

    // Area-weighted sums of the binned quantities around every point of a line.
    struct Bins
    {
      std::vector<double> area, sums; // points, points x names
    };

    /// Positions are evenly spaced on a straight line.
    Bins fill_bins(const Snapshot &body, const std::vector<Point> &positions,
                   const scene::Frame frame, const std::vector<std::string> &names,
                   const double bin)
    {
      const std::vector<Quantity> of = functions(names);
      Bins bins{std::vector<double>(positions.size(), 0.),
                std::vector<double>(positions.size() * names.size(), 0.)};
      const Material &material = body.problem.material;
      const Point a = positions.front(), direction = positions.back() - a;
      const double length = direction.norm(), last = static_cast<double>(positions.size()) - 1.;
      const auto visit = [&](const PatchSample &s)
      {
        // Only points of the line within reach of the sample, by its projection on the line.
        const double along = length > 0. ? (s.x - a).dot(direction) / (length * length) * last : 0.;
        const double reach = length > 0. ? bin * last / length + 1. : 1.;
        const int first = std::max(0, static_cast<int>(std::floor(along - reach)));
        const int end = static_cast<int>(std::min(last, std::ceil(along + reach)));
        for (int k = first; k <= end; ++k)
        {
          if ((s.x - positions[k]).cwiseAbs().maxCoeff() > 0.5 * bin)
            continue;
          const Sample sample{body.points.data() + s.cell * body.problem.mesh.points_per_cell +
                                  s.point,
                              Point::Zero(), Point::Zero(), s.area};
          bins.area[k] += s.area;
          for (std::size_t n = 0; n < of.size(); ++n)
            bins.sums[k * of.size() + n] += s.area * of[n](material, sample);
        }
      };
      const Point half = Point::Constant(0.5 * bin);
      const Point lower = a.cwiseMin(positions.back()) - half;
      const Point upper = a.cwiseMax(positions.back()) + half;
      for (int cell = 0; cell < body.problem.mesh.cells; ++cell)
        if (const scene::Box box = box_of_cell(body, cell, frame);
            (box.upper.array() >= lower.array()).all() &&
            (box.lower.array() <= upper.array()).all())
          for_each_sample_of(body, cell, 4, frame, visit);
      return bins;
    }

    /// Missing outside the body and in folded cells.
    std::vector<double> values_in(const Snapshot &body, const std::optional<Location> &at,
                                  const std::vector<std::string> &names)
    {
      if (!at || body.folded[at->cell])
        return std::vector<double>(names.size(), missing);
      const int point = patch_of(body.problem.mesh, at->unit);
      std::vector<double> values;
      for (const Quantity of : functions(names))
        values.push_back(of(body.problem.material, sample_at(body, *at, point, missing)));
      return values;
    }

    /// Values of `names` at each of some positions on a straight line.
    std::vector<double> sample(const Snapshot &body, const std::vector<Point> &positions,
                               const scene::Frame frame, const std::vector<std::string> &names,
                               const double bin)
    {
      const bool binned = std::any_of(names.begin(), names.end(), is_binned);
      const Bins bins = binned && bin > 0. ? fill_bins(body, positions, frame, names, bin) : Bins{};
      std::vector<double> values;
      for (std::size_t k = 0; k < positions.size(); ++k)
      {
        const std::optional<Location> at = locate_material(body, positions[k], frame);
        const std::vector<double> here = values_in(body, at, names);
        for (std::size_t n = 0; n < names.size(); ++n)
          if (is_binned(names[n]) && !bins.area.empty() && bins.area[k] > 0.)
            values.push_back(!at ? missing : bins.sums[k * names.size() + n] / bins.area[k]);
          else
            values.push_back(here[n]);
      }
      return values;
    }
  } // namespace

  std::vector<double> patch_bounds(const int degree)
  {
    // Gauss weights on [0, 1]: 1/2, 1/2; or 5/18, 8/18, 5/18.
    if (degree == 1)
      return {0., 0.5, 1.};
    return {0., 5. / 18., 13. / 18., 1.};
  }

  int patch_of(const Discretisation &d, const Point &unit)
  {
    const std::vector<double> bound = patch_bounds(d.degree);
    std::array<int, 2> index{};
    for (int k = 0; k < 2; ++k)
      while (index[k] < d.degree && unit[k] > bound[index[k] + 1])
        ++index[k];
    return index[1] * (d.degree + 1) + index[0];
  }

  std::vector<double> values_at(const Snapshot &body, const Point &x, const scene::Frame frame,
                                const std::vector<std::string> &names)
  {
    return values_in(body, locate_material(body, x, frame), names);
  }

  record::LineSample sample_line(const Snapshot &body, const scene::LineProbe &line,
                                 const std::vector<std::string> &names, const double default_bin)
  {
    record::LineSample result;
    for (int k = 0; k < line.points; ++k)
      result.position.push_back(
          line.a +
          (line.b - line.a) * (line.points > 1 ? static_cast<double>(k) / (line.points - 1) : 0.5));
    result.values =
        sample(body, result.position, line.frame, names, line.bin.value_or(default_bin));
    return result;
  }

  std::vector<double> sample_point(const Snapshot &body, const scene::PointProbe &point,
                                   const std::vector<std::string> &names, const double default_bin)
  {
    return sample(body, {point.at}, point.frame, names, point.bin.value_or(default_bin));
  }

  std::vector<double> region_means(const Snapshot &body, const scene::RegionProbe &region,
                                   const std::vector<std::string> &names)
  {
    const std::vector<Quantity> of = functions(names);
    std::vector<double> sums(names.size(), 0.);
    double area = 0.;
    const auto inside = [&](const PatchSample &s)
    {
      if (!region.box)
        return true;
      const Point X = position_in(body, {s.cell, s.unit}, scene::Frame::material);
      return (X.array() >= region.box->lower.array()).all() &&
             (X.array() <= region.box->upper.array()).all();
    };
    for_each_sample(body, region.box ? 4 : 1, scene::Frame::current,
                    [&](const PatchSample &s)
                    {
                      if (!inside(s))
                        return;
                      area += s.area;
                      const Sample sample = sample_at(body, {s.cell, s.unit}, s.point, s.area);
                      for (std::size_t n = 0; n < of.size(); ++n)
                        sums[n] += s.area * of[n](body.problem.material, sample);
                    });
    for (std::size_t n = 0; n < names.size(); ++n)
      sums[n] = names[n] == "area" ? area : (area > 0. ? sums[n] / area : missing);
    return sums;
  }

  record::Snapshot cell_snapshot(const Snapshot &body, const std::vector<std::string> &names)
  {
    const Discretisation &d = body.problem.mesh;
    record::Snapshot snapshot;
    snapshot.kind = record::Snapshot::Kind::cells;
    std::map<int, int> number;
    for (int cell = 0; cell < d.cells; ++cell)
      for (const int corner : {0, 1, 3, 2}) // lexicographic -> counter-clockwise
      {
        const int node = d.nodes_of(cell)[corner];
        const auto [entry, fresh] = number.emplace(node, static_cast<int>(snapshot.vertex.size()));
        if (fresh)
          snapshot.vertex.push_back(d.position[node] +
                                    Point(body.u[2 * node], body.u[2 * node + 1]));
        snapshot.connectivity.push_back(entry->second);
      }
    const std::vector<Quantity> of = functions(names);
    std::vector<double> area(d.cells, 0.);
    std::vector<std::vector<double>> sums(names.size(), std::vector<double>(d.cells, 0.));
    for_each_sample(body, 1, scene::Frame::current,
                    [&](const PatchSample &s)
                    {
                      area[s.cell] += s.area;
                      const Sample sample = sample_at(body, {s.cell, s.unit}, s.point, s.area);
                      for (std::size_t n = 0; n < of.size(); ++n)
                        sums[n][s.cell] += s.area * of[n](body.problem.material, sample);
                    });
    for (std::size_t n = 0; n < names.size(); ++n)
      for (int cell = 0; cell < d.cells; ++cell)
        sums[n][cell] = names[n] == "area" ? area[cell] : sums[n][cell] / area[cell];
    for (std::size_t n = 0; n < names.size(); ++n)
      snapshot.fields[names[n]] = std::move(sums[n]);
    std::vector<double> valid(d.cells);
    std::transform(body.folded.begin(), body.folded.end(), valid.begin(),
                   [](const char folded) { return folded ? 0. : 1.; });
    snapshot.fields["valid"] = std::move(valid);
    return snapshot;
  }

  std::vector<scene::Polyline> outlines(const Snapshot &body)
  {
    const Discretisation &d = body.problem.mesh;
    std::multimap<int, const BoundarySide *> by_start;
    for (const BoundarySide &side : d.boundary)
      by_start.emplace(side.node[0], &side);
    const auto at = [&](const int node)
    { return Point(d.position[node] + Point(body.u[2 * node], body.u[2 * node + 1])); };
    std::vector<scene::Polyline> curves;
    while (!by_start.empty())
    {
      scene::Polyline curve;
      for (auto next = by_start.begin(); next != by_start.end();)
      {
        const BoundarySide &side = *next->second;
        by_start.erase(next);
        curve.push_back(at(side.node[0]));
        if (d.degree == 2) // a parabola: three points between its ends
          for (const double s : {0.25, 0.5, 0.75})
            curve.push_back((2. * s - 1.) * (s - 1.) * at(side.node[0]) +
                            4. * s * (1. - s) * at(side.node[1]) +
                            s * (2. * s - 1.) * at(side.node[2]));
        next = by_start.find(side.node[d.degree]);
      }
      curves.push_back(std::move(curve));
    }
    return curves;
  }
} // namespace fe
