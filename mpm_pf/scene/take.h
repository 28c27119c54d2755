// One overload per kind of value: how a TOML value becomes a field, how a kind is called in
// messages, how a default is printed.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "scene/choices.h"
#include "scene/keys.h"

namespace scene
{
  /// Where a value goes while it is taken: its limits, and who hears what is wrong.
  struct Taking
  {
    const Allowed &allowed;
    Complaints &complaints;
  };

  void take(const Value &, bool &, const Taking &);
  void take(const Value &, int &, const Taking &);
  void take(const Value &, std::uint64_t &, const Taking &);
  void take(const Value &, double &, const Taking &);
  void take(const Value &, std::string &, const Taking &);
  void take(const Value &, Point &, const Taking &);
  void take(const Value &, std::array<int, 2> &, const Taking &);
  void take(const Value &, std::vector<double> &, const Taking &);
  void take(const Value &, std::vector<std::string> &, const Taking &);
  void take(const Value &, Polyline &, const Taking &);
  void take(const Value &, std::vector<Polyline> &, const Taking &);
  void take(const Value &, Expression &, const Taking &);
  void take(const Value &, VectorExpression &, const Taking &);
  void take(const Value &, std::array<Expression, 4> &, const Taking &);
  void take(const Value &, std::array<std::optional<Expression>, 2> &, const Taking &);
  void take(const Value &, Segment &, const Taking &);
  void take(const Value &, Box &, const Taking &);
  void take(const Value &, RegionProbe &, const Taking &);
  void take(const Value &, TipProbe &, const Taking &);
  void take(const Value &, std::array<Boundary, 4> &, const Taking &);

  /// A word that names no choice becomes a complaint.
  void complain_of_word(const Value &, const std::vector<std::string> &known, Complaints &);

  template <class E>
  std::enable_if_t<std::is_enum_v<E>> take(const Value &value, E &field, const Taking &taking)
  {
    std::vector<std::string> known;
    for (const auto &[text, choice] : words(E{}))
    {
      known.push_back(text);
      if (value.kind == Value::Kind::text && value.text == text)
      {
        field = choice;
        return;
      }
    }
    complain_of_word(value, known, taking.complaints);
  }

  template <class T>
  void take(const Value &value, std::optional<T> &field, const Taking &taking)
  {
    take(value, field.emplace(), taking);
  }

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

  /// Declares the keys of one section, each bound to a member of T; a default is what a fresh T
  /// holds.
  template <class T>
  class Keys
  {
  public:
    Keys(const std::string &name, const std::string &sentence)
    {
      section.name = name;
      section.sentence = sentence;
    }
    template <class B, class M>
    Keys &add(const std::string &name, M B::*member, const Allowed &allowed,
              const std::string &sentence, const std::string &reason)
    {
      Key key = declared(name, member, allowed, sentence, reason);
      key.standard = printed(T{}.*member);
      section.keys.push_back(key);
      return *this;
    }
    template <class B, class M>
    Keys &require(const std::string &name, M B::*member, const Allowed &allowed,
                  const std::string &sentence, const std::string &reason)
    {
      Key key = declared(name, member, allowed, sentence, reason);
      key.required = true;
      section.keys.push_back(key);
      return *this;
    }
    Keys &exclusive(const std::vector<std::string> &keys, const bool required = false)
    {
      section.alternatives.push_back({keys, required});
      return *this;
    }
    Section repeated()
    {
      section.repeated = true;
      return section;
    }
    Section required()
    {
      section.required = true;
      return section;
    }
    Section optional() { return section; }

  private:
    Section section;

    template <class B, class M>
    static Key declared(const std::string &name, M B::*member, const Allowed &allowed,
                        const std::string &sentence, const std::string &reason)
    {
      Key key;
      key.name = name;
      key.kind = Kind<M>::text();
      key.allowed = allowed;
      key.sentence = sentence;
      key.reason = reason;
      key.take = [member, allowed](const Value &value, void *target, Complaints &complaints) {
        scene::take(value, static_cast<T *>(target)->*member, Taking{allowed, complaints});
      };
      return key;
    }
  };
} // namespace scene
