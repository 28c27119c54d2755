// How each kind of value is called in messages and in the manual, and how its default is printed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "scene/choices.h"
#include "scene/value.h"

namespace scene
{
  /// What a value must look like: "a number", "two whole numbers [x, y]".
  template <class T>
  struct Kind
  {
    static std::string text()
    {
      std::string result;
      for (const auto &[word, value] : words(T{}))
        result += (result.empty() ? "\"" : ", \"") + word + "\"";
      return "one of " + result;
    }
  };
  template <class T>
  struct Kind<std::optional<T>> : Kind<T>
  {
  };
  template <>
  struct Kind<bool>
  {
    static std::string text() { return "true or false"; }
  };
  template <>
  struct Kind<int>
  {
    static std::string text() { return "a whole number"; }
  };
  template <>
  struct Kind<std::uint64_t> : Kind<int>
  {
  };
  template <>
  struct Kind<double>
  {
    static std::string text() { return "a number"; }
  };
  template <>
  struct Kind<std::string>
  {
    static std::string text() { return "a text"; }
  };
  template <>
  struct Kind<Point>
  {
    static std::string text() { return "two numbers [x, y]"; }
  };
  template <>
  struct Kind<std::array<int, 2>>
  {
    static std::string text() { return "two whole numbers [in x, in y]"; }
  };
  template <>
  struct Kind<std::vector<double>>
  {
    static std::string text() { return "a list of numbers"; }
  };
  template <>
  struct Kind<std::vector<std::string>>
  {
    static std::string text() { return "a list of texts"; }
  };
  template <>
  struct Kind<Polyline>
  {
    static std::string text() { return "a list of at least three points [[x, y], ...]"; }
  };
  template <>
  struct Kind<std::vector<Polyline>>
  {
    static std::string text() { return "a list of outlines [[[x, y], ...], ...]"; }
  };
  template <>
  struct Kind<Expression>
  {
    static std::string text() { return "a number or an expression of X, Y, x, y, t"; }
  };
  template <>
  struct Kind<VectorExpression>
  {
    static std::string text() { return "two numbers or expressions of X, Y, x, y, t"; }
  };
  template <>
  struct Kind<std::array<Expression, 4>>
  {
    static std::string text() { return "four numbers or expressions [xx, yy, zz, xy]"; }
  };
  template <>
  struct Kind<std::array<std::optional<Expression>, 2>>
  {
    static std::string text()
    {
      return "two numbers or expressions of X, Y, x, y, t, or \"free\" for a free component";
    }
  };
  template <>
  struct Kind<Segment>
  {
    static std::string text() { return "two points [[x, y], [x, y]]"; }
  };
  template <>
  struct Kind<Box>
  {
    static std::string text() { return "{lower = [x, y], upper = [x, y]}"; }
  };
  template <>
  struct Kind<RegionProbe>
  {
    static std::string text() { return "\"all\" or {lower = [x, y], upper = [x, y]}"; }
  };
  template <>
  struct Kind<TipProbe>
  {
    static std::string text() { return "{origin = [x, y], direction = [x, y]}"; }
  };
  template <>
  struct Kind<std::array<Boundary, 4>>
  {
    static std::string text()
    {
      return Kind<Boundary>::text() + ", or {left = ..., right = ..., bottom = ..., top = ...}";
    }
  };

  inline std::string printed(const bool value)
  {
    return value ? "true" : "false";
  }
  inline std::string printed(const int value)
  {
    return std::to_string(value);
  }
  inline std::string printed(const std::uint64_t value)
  {
    return std::to_string(value);
  }
  inline std::string printed(const double value)
  {
    return number_text(value);
  }
  inline std::string printed(const std::string &value)
  {
    return value;
  }
  inline std::string printed(const std::array<int, 2> &v)
  {
    return "[" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + "]";
  }
  inline std::string printed(const Point &p)
  {
    return "[" + number_text(p[0]) + ", " + number_text(p[1]) + "]";
  }
  inline std::string printed(const std::array<Boundary, 4> &b)
  {
    return word(b[0]);
  }
  inline std::string printed(const VectorExpression &)
  {
    return "[0, 0]";
  }
  template <class E>
  std::enable_if_t<std::is_enum_v<E>, std::string> printed(const E value)
  {
    return word(value);
  }
  /// An optional key has no default: its reason says what its absence means.
  template <class T>
  std::string printed(const std::optional<T> &)
  {
    return "";
  }
  template <class T>
  std::string printed(const std::vector<T> &)
  {
    return "";
  }
  inline std::string printed(const Expression &e)
  {
    return e.text;
  }
} // namespace scene
