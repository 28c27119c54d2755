#include "norm.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "curve.h"
#include "outline_measure.h"
#include "raster.h"

namespace verify
{
  namespace
  {
    bool ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }
    bool is_relative(const std::string &name)
    {
      return name.rfind("relative", 0) == 0;
    }

    double largest(const Curve &curve)
    {
      double size = 0.;
      for (const double y : curve.y)
        if (std::isfinite(y))
          size = std::max(size, std::abs(y));
      return size;
    }

    double curve_distance(const std::string &name, const CommonSamples &common)
    {
      const auto weight = weights(common);
      double sum = 0., square = 0., most = 0., total = 0.;
      for (std::size_t i = 0; i < common.x.size(); ++i)
      {
        const double difference = std::abs(common.a[i] - common.b[i]);
        most = std::max(most, difference);
        sum += weight[i] * difference;
        square += weight[i] * difference * difference;
        total += weight[i];
      }
      if (ends_with(name, "max"))
        return most;
      if (ends_with(name, "rms"))
        return std::sqrt(square / total);
      if (ends_with(name, "l2"))
        return std::sqrt(square);
      if (ends_with(name, "mean"))
        return sum / total;
      throw MissingData(fmt::format("the norm `{}` compares no curves", name));
    }

    double curve_size(const std::string &name, const Curve &reference)
    {
      if (!ends_with(name, "l2"))
        return largest(reference);
      Curve zero = reference;
      for (auto &y : zero.y)
        y = std::isfinite(y) ? 0. : y;
      return curve_distance(name, common_samples(zero, reference, 0.));
    }

    double raster_size(const Raster &raster)
    {
      double size = 0.;
      for (const auto &[index, mean] : raster.mean)
        size = std::max(size, std::abs(mean));
      return size;
    }

    double outline_distance(const std::string &name, const Outline &a, const Outline &b)
    {
      if (name == "hausdorff")
        return hausdorff(a, b);
      if (name == "rms_distance")
        return rms_distance(a, b);
      if (ends_with(name, "symmetric_difference"))
        return symmetric_difference(a, b);
      throw MissingData(fmt::format("the norm `{}` compares no outlines", name));
    }

    double raw_distance(const Norm &norm, const Quantity &a, const Quantity &b)
    {
      if (a.index() != b.index())
        throw MissingData("what was taken and what it is held against are not of one kind");
      if (const auto *number = std::get_if<double>(&a))
        return std::abs(*number - std::get<double>(b));
      if (const auto *curve = std::get_if<Curve>(&a))
        return curve_distance(norm.name, common_samples(*curve, std::get<Curve>(b), norm.coverage));
      if (const auto *raster = std::get_if<Raster>(&a))
        return curve_distance(norm.name,
                              common_squares(*raster, std::get<Raster>(b), norm.coverage));
      return outline_distance(norm.name, std::get<Outline>(a), std::get<Outline>(b));
    }

    double size(const Norm &norm, const Quantity &reference)
    {
      if (const auto *number = std::get_if<double>(&reference))
        return std::abs(*number);
      if (const auto *curve = std::get_if<Curve>(&reference))
        return curve_size(norm.name, *curve);
      if (const auto *raster = std::get_if<Raster>(&reference))
        return raster_size(*raster);
      return area(std::get<Outline>(reference));
    }
  } // namespace

  double distance(const Norm &norm, const Quantity &a, const Quantity &b, const Quantity &size_of)
  {
    double value = raw_distance(norm, a, b);
    if (norm.scale && !(std::abs(*norm.scale) > 0. && std::isfinite(*norm.scale)))
      throw MissingData(fmt::format("the scale is {}: nothing can be divided by it", *norm.scale));
    if (norm.scale)
      value /= std::abs(*norm.scale);
    else if (is_relative(norm.name))
    {
      const double reference = size(norm, size_of);
      if (!(reference > 0.))
        throw MissingData("a relative norm of a reference that is zero: use an absolute norm or "
                          "`scale`");
      value /= reference;
    }
    if (!std::isfinite(value))
      throw MissingData(fmt::format("the norm is {}", value));
    return value;
  }
} // namespace verify
