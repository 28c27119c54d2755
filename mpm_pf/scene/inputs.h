// Sections as they are written, where that differs from what they mean: a body names its shape's
// keys side by side, a probe its kind by a key. build.h turns them into the plain data of scene.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/choices.h"

namespace scene
{
  enum class Accuracy
  {
    draft,
    standard,
    fine
  };
  inline Words<Accuracy> words(Accuracy)
  {
    return {{"draft", Accuracy::draft}, {"standard", Accuracy::standard}, {"fine", Accuracy::fine}};
  }

  struct Header
  {
    std::string title;
    std::optional<Accuracy> accuracy;
    std::vector<std::string> include;
  };

  struct UnitsInput
  {
    Units system = Units::si;
  };

  struct BodyInput
  {
    std::optional<std::string> name;
    std::optional<Shape> shape;
    std::optional<Point> corner, size, centre;
    std::optional<double> radius, inner_radius, outer_radius;
    std::optional<Polyline> vertices;
    std::optional<std::vector<Polyline>> holes;
    std::optional<std::string> file, record, probe;
    std::optional<double> time, cut_above, cut_below;
    VectorExpression velocity;
    std::optional<std::array<Expression, 4>> initial_stress;
  };

  struct WhereInput
  {
    std::optional<std::string> name;
    std::optional<Edge> on;
    std::optional<Segment> segment;
    std::optional<Box> region;
  };
  struct SupportInput : WhereInput
  {
    std::array<std::optional<Expression>, 2> displacement;
  };
  struct TractionInput : WhereInput
  {
    VectorExpression traction;
    std::optional<Expression> pressure;
  };

  struct ProbeInput
  {
    std::string name;
    std::optional<Segment> line;
    std::optional<Point> at;
    std::optional<RegionProbe> region;
    std::optional<std::string> reaction;
    std::optional<OutlineProbe::Of> outline;
    std::optional<bool> snapshot, history;
    std::optional<TipProbe> tip;
    std::optional<int> points;
    std::optional<double> bin;
    std::optional<Frame> frame;
    std::vector<std::string> of;
    std::vector<double> times, compressions;
    std::optional<double> every;
  };
} // namespace scene
