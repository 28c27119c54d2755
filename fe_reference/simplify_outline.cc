#include "simplify_outline.h"

#include <algorithm>

namespace fe
{
  namespace
  {
    using scene::Point;
    using scene::Polyline;

    double distance_to_segment(const Point &p, const Point &a, const Point &b)
    {
      const Point along = b - a;
      const double squared = along.squaredNorm();
      const double s = squared > 0. ? std::min(1., std::max(0., (p - a).dot(along) / squared)) : 0.;
      return (p - a - s * along).norm();
    }

    // Marks what is kept between first and last, which are kept already.
    void keep_between(const Polyline &open, const std::size_t first, const std::size_t last,
                      const double tolerance, std::vector<char> &kept)
    {
      double farthest = tolerance;
      std::size_t split = first;
      for (std::size_t k = first + 1; k < last; ++k)
      {
        const double distance = distance_to_segment(open[k], open[first], open[last]);
        if (distance > farthest)
        {
          farthest = distance;
          split = k;
        }
      }
      if (split == first)
        return;
      kept[split] = 1;
      keep_between(open, first, split, tolerance, kept);
      keep_between(open, split, last, tolerance, kept);
    }

    // What the outline would lose with its vertex k.
    double sharpness(const Polyline &closed, const std::size_t k)
    {
      const std::size_t n = closed.size();
      return distance_to_segment(closed[k], closed[(k + n - 1) % n], closed[(k + 1) % n]);
    }

    // Of two vertices closer than `gap` the flatter one goes: a corner, say where the body meets a
    // symmetry side, must stay whatever comes just before it.
    void part_close_pairs(Polyline &closed, const double gap)
    {
      for (std::size_t k = 0; k < closed.size() && closed.size() > 3;)
      {
        const std::size_t next = (k + 1) % closed.size();
        if ((closed[next] - closed[k]).norm() >= gap)
        {
          ++k;
          continue;
        }
        const std::size_t flatter = sharpness(closed, k) < sharpness(closed, next) ? k : next;
        closed.erase(closed.begin() + static_cast<std::ptrdiff_t>(flatter));
        k = k > 0 ? k - 1 : 0;
      }
    }
  } // namespace

  scene::Polyline simplify_outline(const scene::Polyline &outline, const double tolerance,
                                   const double gap)
  {
    if (outline.size() < 4)
      return outline;
    Polyline open = outline;
    open.push_back(outline.front());
    // A closed curve is split where it is farthest from its first vertex.
    std::size_t opposite = 0;
    for (std::size_t k = 1; k < outline.size(); ++k)
      if ((outline[k] - outline[0]).norm() > (outline[opposite] - outline[0]).norm())
        opposite = k;
    std::vector<char> kept(open.size(), 0);
    kept.front() = kept[opposite] = kept.back() = 1;
    keep_between(open, 0, opposite, tolerance, kept);
    keep_between(open, opposite, open.size() - 1, tolerance, kept);

    Polyline result;
    for (std::size_t k = 0; k + 1 < open.size(); ++k)
      if (kept[k])
        result.push_back(open[k]);
    part_close_pairs(result, gap);
    return result.size() < 3 ? outline : result;
  }
} // namespace fe
