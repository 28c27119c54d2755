#include "scene/nearest_name.h"

#include <algorithm>

namespace scene
{
  namespace
  {
    // Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours.
    std::size_t edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
      for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j)
        {
          if (i == 0 || j == 0)
          {
            d[i][j] = i + j;
            continue;
          }
          d[i][j] = std::min(
              {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
          if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
            d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
      return d[a.size()][b.size()];
    }
  } // namespace

  std::string nearest_name(const std::string &written, const std::vector<std::string> &known)
  {
    std::size_t smallest = written.size() / 3 + 2;
    std::string nearest;
    for (const std::string &candidate : known)
      if (const std::size_t distance = edit_distance(written, candidate); distance < smallest)
      {
        smallest = distance;
        nearest = candidate;
      }
    return nearest;
  }
} // namespace scene
