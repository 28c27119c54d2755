#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/build.h"
#include "scene/geometry.h"

namespace scene
{
  namespace
  {
    const std::vector<Form> &shapes()
    {
      static const std::vector<Form> forms{
          {"rectangle", {"corner", "size"}, {}},
          {"disc", {"centre", "radius"}, {}},
          {"ring", {"centre", "inner_radius", "outer_radius"}, {}},
          {"polygon", {"vertices"}, {"holes"}},
          {"outline", {"file"}, {}},
          {"record", {"record", "probe"}, {"time", "cut_above", "cut_below"}}};
      return forms;
    }

    std::string beside(const std::string &file, const std::string &path)
    {
      return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
    }

    std::vector<Polyline> outlines_of_file(const BodyInput &input, const Value &at, Draft &draft,
                                           ErrorList &errors)
    {
      const Value &key = *at.find("file");
      const std::string path = beside(key.place.file, *input.file);
      std::ifstream stream(path);
      std::error_code ignored;
      if (!stream || !std::filesystem::is_regular_file(path, ignored))
      {
        errors.add(key, path + ": there is no such file, or it cannot be read", "",
                   "give a path relative to the scene file");
        return {};
      }
      std::ostringstream text;
      text << stream.rdbuf();
      draft.file_texts += text.str();
      try
      {
        return read_outlines(text.str(), path);
      }
      catch (const std::runtime_error &error)
      {
        errors.add(key, error.what(), "lines of x,y; a blank line between outlines",
                   "correct the file");
        return {};
      }
    }

    double size_of(const Polyline &line)
    {
      Point lower = line[0], upper = line[0];
      for (const Point &p : line)
      {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
      }
      return (upper - lower).norm();
    }

    // Vertices that repeat, no area: nothing that a solid could fill.
    void check_outlines(const std::vector<Polyline> &outlines, const Value &at, ErrorList &errors)
    {
      for (const Polyline &line : outlines)
      {
        if (line.size() < 3)
        {
          errors.add(at, "an outline of " + std::to_string(line.size()) + " points",
                     "at least three points", "add points");
          continue;
        }
        const double size = size_of(line);
        if (!(std::abs(signed_area(line)) > 1e-12 * size * size))
          errors.add(at, "an outline without area", "a closed outline around an area",
                     "list the vertices in order around the body");
        for (std::size_t i = 0; i < line.size(); ++i)
          if ((line[(i + 1) % line.size()] - line[i]).norm() <= 1e-12 * size)
          {
            errors.add(at,
                       "the outline repeats the point (" + number_text(line[i][0]) + ", " +
                           number_text(line[i][1]) + ")",
                       "every vertex once; the outline is closed by itself",
                       "remove the repeated point");
            break;
          }
        if (!errors.about(at) && crosses_itself(line))
          errors.add(at, "the outline crosses or touches itself",
                     "a line around the body that meets itself nowhere",
                     "list the vertices in order around the body; separate pieces and holes are "
                     "outlines of their own");
      }
    }

    // Where they overlap or lie outside, the even-odd rule would make material of holes.
    void check_holes(const Polyline &rim, const std::vector<Polyline> &holes, const Value &at,
                     ErrorList &errors)
    {
      for (std::size_t i = 0; i < holes.size(); ++i)
      {
        const double area = std::abs(signed_area(holes[i])), rounding = 1e-9 * area;
        const std::string which = "hole " + std::to_string(i + 1);
        if (shared_area(holes[i], rim) < area - rounding)
          errors.add(at, which + " is not within the vertices' outline", "holes of the polygon",
                     "move the hole; what cuts the rim belongs to the vertices");
        for (std::size_t j = 0; j < i; ++j)
          if (shared_area(holes[i], holes[j]) > rounding)
            errors.add(at, which + " overlaps hole " + std::to_string(j + 1),
                       "holes apart from each other", "join them to one outline");
      }
    }
  } // namespace

  std::vector<Polyline> read_outlines(const std::string &text, const std::string &file)
  {
    std::vector<Polyline> outlines;
    bool inside = false;
    int number = 0;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
    {
      ++number;
      const std::size_t first = line.find_first_not_of(" \t\r");
      if (first == std::string::npos)
      {
        inside = false;
        continue;
      }
      if (line[first] == '#')
        continue;
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream words(line);
      double x = 0., y = 0.;
      std::string rest;
      if (!(words >> x >> y) || (words >> rest) || !std::isfinite(x) || !std::isfinite(y))
        throw std::runtime_error(file + ":" + std::to_string(number) + ": \"" + line +
                                 "\" is not two numbers x,y");
      if (!inside)
        outlines.emplace_back();
      inside = true;
      outlines.back().emplace_back(x, y);
    }
    // A program that repeats the first vertex to close the outline means the same outline.
    for (Polyline &outline : outlines)
      if (outline.size() > 3 && outline.front() == outline.back())
        outline.pop_back();
    if (outlines.empty())
      throw std::runtime_error(file + ": it holds no points");
    return outlines;
  }

  void build_body(const BodyInput &input, const Value &at, Draft &draft, ErrorList &errors)
  {
    Body body;
    body.name = input.name
                    ? *input.name
                    : "body " + std::to_string(&at - draft.root.find("body")->items.data() + 1);
    body.velocity = input.velocity;
    body.initial_stress = input.initial_stress;
    body.place = at.place;
    const std::size_t before = errors.count();
    if (!input.shape ||
        !fits(shapes().at(static_cast<std::size_t>(*input.shape)), shapes(), at, errors) ||
        errors.about(at))
      return;
    switch (*input.shape)
    {
    case Shape::rectangle:
      body.shape = Rectangle{*input.corner, *input.size};
      break;
    case Shape::disc:
      body.shape = Disc{*input.centre, *input.radius};
      break;
    case Shape::ring:
      if (*input.inner_radius >= *input.outer_radius)
        errors.add(*at.find("inner_radius"), "the inner radius is not below the outer one",
                   "inner_radius < outer_radius", "exchange them");
      body.shape = Ring{*input.centre, *input.inner_radius, *input.outer_radius};
      break;
    case Shape::polygon:
    {
      Polygon polygon{{*input.vertices}};
      if (input.holes)
        polygon.outlines.insert(polygon.outlines.end(), input.holes->begin(), input.holes->end());
      check_outlines(polygon.outlines, *at.find("vertices"), errors);
      if (input.holes && !errors.about(*at.find("vertices")))
        check_holes(*input.vertices, *input.holes, *at.find("holes"), errors);
      body.shape = polygon;
      break;
    }
    case Shape::outline:
    {
      Polygon polygon{outlines_of_file(input, at, draft, errors)};
      check_outlines(polygon.outlines, *at.find("file"), errors);
      body.shape = polygon;
      break;
    }
    case Shape::record:
      body.shape =
          RecordedOutline{beside(at.find("record")->place.file, *input.record), *input.probe,
                          input.time.value_or(-1.), input.cut_above, input.cut_below};
      break;
    }
    if (errors.count() > before)
      return;
    draft.scene.bodies.push_back(body);
    draft.bodies.push_back(&at);
  }
} // namespace scene
