#include "csv.h"

#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "quantity.h"
#include "section.h"

namespace verify
{
  namespace
  {
    std::vector<std::string> fields(const std::string &line)
    {
      std::vector<std::string> result;
      std::stringstream stream(line);
      std::string field;
      while (std::getline(stream, field, ','))
      {
        const auto first = field.find_first_not_of(" \t\r\""),
                   last = field.find_last_not_of(" \t\r\"");
        result.push_back(first == std::string::npos ? "" : field.substr(first, last - first + 1));
      }
      return result;
    }

    double to_number(const std::string &text, const std::string &path, const int line)
    {
      try
      {
        std::size_t used = 0;
        const double value = std::stod(text, &used);
        if (used == text.size())
          return value;
      }
      catch (const std::exception &)
      {
      }
      throw BadInput(fmt::format("{}:{}: `{}` is not a number", path, line, text));
    }
  } // namespace

  ColumnData read_csv(const std::string &path)
  {
    std::ifstream stream(path);
    if (!stream)
      throw MissingReference(fmt::format("the reference table {} is missing", path));
    ColumnData columns;
    std::vector<std::string> header;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
    {
      const auto row = fields(line);
      if (row.empty() || (row.size() == 1 && row[0].empty()) || row[0][0] == '#')
        continue;
      if (header.empty())
      {
        header = row;
        for (const auto &name : header)
          columns[name];
        continue;
      }
      if (row.size() != header.size())
        throw BadInput(fmt::format("{}:{}: {} fields under {} headings", path, number, row.size(),
                                   header.size()));
      for (std::size_t k = 0; k < row.size(); ++k)
        columns[header[k]].push_back(to_number(row[k], path, number));
    }
    if (header.empty())
      throw BadInput(fmt::format("{}: no header line", path));
    return columns;
  }
} // namespace verify
