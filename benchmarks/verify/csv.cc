#include "csv.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
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
      char *end = nullptr; // of std::stod a denormal number would be none
      const double value = std::strtod(text.c_str(), &end);
      if (!text.empty() && *end == '\0')
        return value;
      throw BadInput(fmt::format("{}:{}: `{}` is not a number", path, line, text));
    }
    /// A heading is a name of expressions.
    void check_heading(const std::string &name, const std::string &path, const int line)
    {
      const auto part_of_a_name = [](const unsigned char c) { return std::isalnum(c) || c == '_'; };
      if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) ||
          !std::all_of(name.begin(), name.end(), part_of_a_name))
        throw BadInput(fmt::format("{}:{}: the heading `{}` is no name: write letters, digits and "
                                   "_, a letter first",
                                   path, line, name));
    }

    // What spreadsheets write before a text in UTF-8.
    const std::string byte_order_mark = "\xEF\xBB\xBF";
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
      if (number == 1 && line.rfind(byte_order_mark, 0) == 0)
        line.erase(0, byte_order_mark.size());
      const auto row = fields(line);
      if (row.empty() || (row.size() == 1 && row[0].empty()) || row[0][0] == '#')
        continue;
      if (header.empty())
      {
        header = row;
        for (const auto &name : header)
        {
          check_heading(name, path, number);
          if (!columns.emplace(name, std::vector<double>()).second)
            throw BadInput(fmt::format("{}:{}: two headings are `{}`: rename one of them", path,
                                       number, name));
        }
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
