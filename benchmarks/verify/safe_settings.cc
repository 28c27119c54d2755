#include "safe_settings.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "merged_scene.h"
#include "stability_cells.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    using Json = nlohmann::json;

    /// A value taken apart: its numbers, and the text around them with # in their places, free of
    /// quotes and blanks.
    struct Parts
    {
      std::string around;
      std::vector<double> numbers;
    };

    Parts parts_of(const std::string &value)
    {
      std::string text;
      for (const char c : value)
        if (c != '"' && c != '\'' && c != ' ')
          text += c;
      Parts parts;
      const char *at = text.c_str();
      while (*at != '\0')
      {
        const char before = parts.around.empty() ? '[' : parts.around.back();
        const bool digit = std::isdigit(static_cast<unsigned char>(at[*at == '-' ? 1 : 0])) != 0;
        // "weno5" holds no number, and in "a-1" the sign is an operator
        const bool starts = *at == '-' ? before == '[' || before == ',' || before == '('
                                       : !std::isalnum(static_cast<unsigned char>(before));
        if (digit && starts)
        {
          char *end = nullptr;
          parts.numbers.push_back(std::strtod(at, &end));
          parts.around += '#';
          at = end;
        }
        else
          parts.around += *at++;
      }
      return parts;
    }

    /// How far the scene is from a value of the axis; nothing where the two differ in more than
    /// numbers.
    std::optional<double> distance(const Json &axis, const std::string &value,
                                   const MergedScene &scene)
    {
      double sum = 0.;
      for (const std::string &form : axis.value("set", std::vector<std::string>()))
      {
        const std::size_t equals = form.find('=');
        if (equals == std::string::npos || form.find('{', equals) == std::string::npos)
          continue;
        const std::string there = with_value(form.substr(equals + 1), value);
        const Parts own = parts_of(scene.value(form.substr(0, equals))),
                    other = parts_of(there.empty() ? absent_value : there);
        if (own.around != other.around)
          return {};
        for (std::size_t k = 0; k < own.numbers.size(); ++k)
        {
          const double a = own.numbers[k], b = other.numbers[k];
          const bool logarithmic = axis.value("logarithmic", false) && a > 0. && b > 0.;
          sum += std::pow(logarithmic ? std::log(a / b) : a - b, 2);
        }
      }
      return std::sqrt(sum);
    }

    /// The column or row that the scene is nearest to; of an axis that is not there the only one.
    std::optional<std::size_t> nearest_on(const Json &axis, const MergedScene &scene)
    {
      const auto values = axis.value("values", std::vector<std::string>());
      if (values.empty())
        return 0;
      std::optional<std::size_t> best;
      double smallest = INFINITY;
      for (std::size_t k = 0; k < values.size(); ++k)
        if (const auto far = distance(axis, values[k], scene); far && *far < smallest)
        {
          smallest = *far;
          best = k;
        }
      return best;
    }

    std::vector<Json> all_cells(const Json &map)
    {
      auto cells = map.at("cells").get<std::vector<Json>>();
      for (const auto &cell : map.value("bisected", Json::array()))
        cells.push_back(cell);
      return cells;
    }

    /// The accurate cell nearest to the scene along an axis ("x" or "y"), else the nearest bounded
    /// one, among those with the other's index `index`, but for the scene's own value; null if
    /// there is none.
    Json nearest_safe(const Json &map, const std::string &along, const std::size_t index,
                      const MergedScene &scene)
    {
      const std::string held = along == "x" ? "row" : "column";
      Json best;
      double smallest = INFINITY;
      for (const char *wanted : {"accurate", "bounded but wrong"})
      {
        for (const auto &cell : all_cells(map))
          if (cell.at("class") == wanted && cell.contains(held) && cell.at(held) == index)
            if (const auto far = distance(map.at(along), cell.at(along), scene);
                far && *far > 0. && *far < smallest)
            {
              smallest = *far;
              best = cell;
            }
        if (!best.is_null())
          return best;
      }
      return best;
    }

    bool safe(const Json &cell)
    {
      return cell.at("class") == "accurate" || cell.at("class") == "bounded but wrong";
    }

    /// Whether the map calls the very settings of the scene safe: then others are to blame.
    bool calls_safe(const Json &map, const MergedScene &scene)
    {
      const auto cells = all_cells(map);
      return std::any_of(cells.begin(), cells.end(),
                         [&](const Json &cell)
                         {
                           return safe(cell) && distance(map.at("x"), cell.at("x"), scene) == 0. &&
                                  distance(map.at("y"), cell.at("y"), scene) == 0.;
                         });
    }

    std::string setting(const Json &map, const std::string &axis, const Json &cell)
    {
      return map.at(axis).at("label").get<std::string>() + " = " + cell.at(axis).get<std::string>();
    }

    std::string advice(const Json &map, const MergedScene &scene)
    {
      const auto column = nearest_on(map.at("x"), scene), row = nearest_on(map.at("y"), scene);
      if (!column || !row || calls_safe(map, scene))
        return "";
      std::string text;
      for (const std::string along : {"x", "y"})
      {
        const std::string other = along == "x" ? "y" : "x";
        const Json cell = nearest_safe(map, along, along == "x" ? *row : *column, scene);
        if (map.at(along).at("values").empty() || cell.is_null())
          continue;
        const std::string beside =
            map.at(other).at("values").empty() ? "" : " with " + setting(map, other, cell);
        text += fmt::format("known to be {}: {}{} ({})\n", cell.at("class").get<std::string>(),
                            setting(map, along, cell), beside, map.at("name").get<std::string>());
      }
      return text;
    }

    /// The maps of the case: of this folder, else of a suite beside it; null if there are none.
    Json maps_of(const std::string &output, const std::string &name, std::string &file)
    {
      const fs::path whole = fs::absolute(output + "/.").lexically_normal(); // ends in a slash
      const fs::path beside = whole.parent_path().parent_path();
      for (const fs::path &folder : {fs::path(output), beside / "full", beside / "quick"})
      {
        file = (folder / "stability" / (name + ".json")).string();
        std::ifstream stream(file);
        const Json stability = stream ? Json::parse(stream, nullptr, false) : Json();
        if (stability.is_object() && stability.contains("maps"))
          return stability.at("maps");
      }
      return {};
    }
  } // namespace

  std::string nearest_safe_setting(const std::string &output, const Case &c, const Run &run)
  {
    std::string file, text;
    const Json maps = maps_of(output, c.name, file);
    if (maps.is_null())
      return text;
    const MergedScene scene = merged_scene(c, run);
    for (const auto &map : maps)
      text += advice(map, scene);
    return text.empty() ? text : text + "(of the maps in " + file + ")\n";
  }
} // namespace verify
