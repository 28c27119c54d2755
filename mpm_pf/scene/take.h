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
      key.take = [member, allowed](const Value &value, void *target, Complaints &complaints) {
        scene::take(value, static_cast<T *>(target)->*member, Taking{allowed, complaints});
      };
      return key;
    }
  };
} // namespace scene
