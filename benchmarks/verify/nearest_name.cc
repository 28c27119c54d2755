#include "nearest_name.h"

#include <algorithm>
#include <vector>

namespace verify
{
  namespace
  {
    /// Letters to insert, delete or replace (Levenshtein).
    std::size_t edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
      for (std::size_t i = 1; i <= a.size(); ++i)
      {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
          const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
          diagonal = row[j];
          row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
      }
      return row.back();
    }
  } // namespace

  std::string nearest_name(const std::string &written, const std::set<std::string> &known)
  {
    std::string nearest;
    std::size_t smallest = std::min<std::size_t>(4, written.size());
    for (const auto &name : known)
      if (const std::size_t distance = edit_distance(written, name); distance < smallest)
      {
        smallest = distance;
        nearest = name;
      }
    return nearest;
  }
} // namespace verify
