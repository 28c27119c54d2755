// How a TOML value becomes a field, one overload per kind of value, and how a section's keys are
// bound to the fields of a struct.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "scene/choices.h"
#include "scene/keys.h"
#include "scene/kinds.h"

namespace scene
{
  /// What reading a value needs beside it: its limits, and the list of errors.
  struct ReadContext
  {
    const Allowed &allowed;
    ErrorList &errors;
  };

  void read_value(const Value &, bool &, const ReadContext &);
  void read_value(const Value &, int &, const ReadContext &);
  void read_value(const Value &, std::uint64_t &, const ReadContext &);
  void read_value(const Value &, double &, const ReadContext &);
  void read_value(const Value &, std::string &, const ReadContext &);
  void read_value(const Value &, Point &, const ReadContext &);
  void read_value(const Value &, std::array<int, 2> &, const ReadContext &);
  void read_value(const Value &, std::vector<double> &, const ReadContext &);
  void read_value(const Value &, std::vector<std::string> &, const ReadContext &);
  void read_value(const Value &, Polyline &, const ReadContext &);
  void read_value(const Value &, std::vector<Polyline> &, const ReadContext &);
  void read_value(const Value &, Expression &, const ReadContext &);
  void read_value(const Value &, VectorExpression &, const ReadContext &);
  void read_value(const Value &, std::array<Expression, 4> &, const ReadContext &);
  void read_value(const Value &, std::array<std::optional<Expression>, 2> &, const ReadContext &);
  void read_value(const Value &, Segment &, const ReadContext &);
  void read_value(const Value &, Box &, const ReadContext &);
  void read_value(const Value &, RegionProbe &, const ReadContext &);
  void read_value(const Value &, TipProbe &, const ReadContext &);
  void read_value(const Value &, std::array<Boundary, 4> &, const ReadContext &);

  /// A word that names no choice becomes an error.
  void add_unknown_word(const Value &, const std::vector<std::string> &known, ErrorList &);

  template <class E>
  std::enable_if_t<std::is_enum_v<E>> read_value(const Value &value, E &field,
                                                 const ReadContext &context)
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
    add_unknown_word(value, known, context.errors);
  }

  template <class T>
  void read_value(const Value &value, std::optional<T> &field, const ReadContext &context)
  {
    read_value(value, field.emplace(), context);
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
      key.default_text = printed(T{}.*member);
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
    /// The key just required may be left out where the top of the file has `key`, which chooses it.
    Keys &chosen_by(const std::string &key)
    {
      section.keys.back().chosen_by = key;
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
      key.read = [member, allowed](const Value &value, void *target, ErrorList &errors) {
        scene::read_value(value, static_cast<T *>(target)->*member, ReadContext{allowed, errors});
      };
      return key;
    }
  };
} // namespace scene
