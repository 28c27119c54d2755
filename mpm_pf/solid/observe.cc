// Lines, points, regions and snapshots, from the fields of the points.
#include <algorithm>
#include <limits>

#include "scene/geometry.h"
#include "scene/quantities.h"
#include "solid/fields.h"

namespace solid
{
  namespace
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();

    bool is_motion(const std::string &name)
    {
      return name.rfind("displacement", 0) == 0 || name.rfind("velocity", 0) == 0;
    }

    double overlap(const double a, const double half_a, const double b, const double half_b)
    {
      return std::max(0., std::min(a + half_a, b + half_b) - std::max(a - half_a, b - half_b));
    }

    struct Bin
    {
      Point centre;
      double side;
    };

    // Mean over a square bin, points as squares of their areas; missing if less than
    // a fifth of the bin is filled (a corner of the body fills a quarter).
    double bin_mean(const Solid &solid, const Neighbours &neighbours, const Frame frame,
                    const std::vector<double> &field, const Bin &bin)
    {
      const Point &at = bin.centre;
      double sum = 0., filled = 0.;
      neighbours.near(at, 0.5 * bin.side + solid.grid.dx,
                      [&](const std::size_t k)
                      {
                        const std::size_t p = neighbours.chosen[k];
                        const Point x = position(solid, p, frame);
                        const double half = 0.5 * std::sqrt(area_of(solid, p, frame));
                        const double area = overlap(x[0], half, at[0], 0.5 * bin.side) *
                                            overlap(x[1], half, at[1], 0.5 * bin.side);
                        sum += area * field[k], filled += area;
                      });
      return filled > 0.2 * bin.side * bin.side ? sum / filled : none;
    }

    /// What samples at these positions take into account: quantities are not computed elsewhere, so
    /// that a point does not cost what a snapshot does.
    PointSelection near(const Solid &solid, const std::vector<Point> &positions, const Frame frame,
                        const double bin)
    {
      scene::Box box{positions.front(), positions.front()};
      for (const Point &x : positions)
        box.lower = box.lower.cwiseMin(x), box.upper = box.upper.cwiseMax(x);
      const Point reach = Point::Constant(0.5 * bin + 2. * solid.grid.dx);
      box.lower -= reach, box.upper += reach;
      return points_in(solid, frame, box);
    }

    std::vector<double> sample(const Solid &solid, const std::vector<Point> &positions,
                               const Frame frame, const double bin,
                               const std::vector<std::string> &of)
    {
      const Neighbours neighbours(solid, frame, near(solid, positions, frame, bin));
      std::vector<double> values(positions.size() * of.size());
      for (std::size_t k = 0; k < of.size(); ++k)
      {
        const std::vector<double> values_of_points = field(solid, of[k], neighbours.chosen);
        for (std::size_t m = 0; m < positions.size(); ++m)
          values[m * of.size() + k] =
              is_motion(of[k])
                  ? fit(solid, neighbours, frame, values_of_points, positions[m]).value
                  : bin_mean(solid, neighbours, frame, values_of_points, {positions[m], bin});
      }
      return values;
    }
  } // namespace

  record::LineSample sample_line(const Solid &solid, const scene::LineProbe &probe,
                                 const std::vector<std::string> &of)
  {
    record::LineSample sampled;
    for (int k = 0; k < probe.points; ++k)
    {
      const double s = probe.points > 1 ? k / (probe.points - 1.) : 0.;
      sampled.position.push_back((1. - s) * probe.a + s * probe.b);
    }
    sampled.values =
        sample(solid, sampled.position, probe.frame, probe.bin.value_or(solid.bin), of);
    return sampled;
  }

  std::vector<double> sample_point(const Solid &solid, const scene::PointProbe &probe,
                                   const std::vector<std::string> &of)
  {
    return sample(solid, {probe.at}, probe.frame, probe.bin.value_or(solid.bin), of);
  }

  std::vector<double> region_means(const Solid &solid, const scene::RegionProbe &probe,
                                   const std::vector<std::string> &of)
  {
    const double tolerance = 1e-9 * solid.grid.dx;
    PointSelection inside;
    std::vector<double> weight;
    double area = 0.;
    for (std::size_t p = 0; p < solid.points.size(); ++p)
    {
      const Point X = position(solid, p, Frame::material);
      if (probe.box && !scene::contains(*probe.box, *probe.box, X, tolerance))
        continue;
      inside.push_back(static_cast<std::uint32_t>(p));
      weight.push_back(area_of(solid, p, Frame::current));
      area += weight.back();
    }
    std::vector<double> means;
    for (const std::string &name : of)
    {
      const std::vector<double> values = field(solid, name, inside);
      double sum = 0.;
      for (std::size_t k = 0; k < weight.size(); ++k)
        sum += weight[k] > 0. ? weight[k] * values[k] : 0.;
      means.push_back(!(area > 0.) ? none : name == "area" ? area : sum / area);
    }
    return means;
  }

  record::Snapshot snapshot(const Solid &solid, const std::vector<std::string> &of)
  {
    record::Snapshot taken;
    taken.kind = record::Snapshot::Kind::points;
    const std::size_t count = solid.points.size();
    std::vector<double> &X = taken.fields["initial_x"], &Y = taken.fields["initial_y"];
    taken.vertex.reserve(count), X.reserve(count), Y.reserve(count);
    for (std::size_t p = 0; p < count; ++p)
    {
      taken.vertex.push_back(position(solid, p, Frame::current));
      const Point initial = position(solid, p, Frame::material);
      X.push_back(initial[0]), Y.push_back(initial[1]);
    }
    std::vector<std::string> names = of;
    if (names.empty())
      names.assign(scene::solid_quantities.begin(), scene::solid_quantities.end());
    const PointSelection all = all_points(solid);
    for (const std::string &name : names)
      taken.fields[name] = field(solid, name, all);
    return taken;
  }
} // namespace solid
