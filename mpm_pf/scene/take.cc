#include "scene/take.h"

#include <cmath>

#include "scene/expression.h"

namespace scene
{
  namespace
  {
    template <class T>
    void refuse(const Value &value, const Taking &taking)
    {
      const std::string range = taking.allowed.range.text();
      taking.complaints.add(value, "read " + inline_text(value),
                            Kind<T>::text() + (range.empty() ? "" : ", " + range),
                            "write it that way");
    }

    // What numbers a key takes, said where one is outside.
    bool check_range(const Value &value, const double number, const Taking &taking)
    {
      const Range &range = taking.allowed.range;
      if (std::isfinite(number) && range.holds(number))
        return true;
      const std::string unit = unit_text(taking.allowed.dimension, Units::si);
      taking.complaints.add(
          value, "read " + number_text(number),
          range.text().empty() ? "a finite number" : range.text(),
          "change the value" +
              (unit.empty() ? "" : "; is it given in the right unit (SI: " + unit + ")?"));
      return false;
    }

    bool is_list(const Value &value, const std::size_t length)
    {
      return value.kind == Value::Kind::array && value.items.size() == length;
    }

    // An array of exactly N, each taken by its own kind.
    template <class Whole, class Each>
    void take_each(const Value &value, Each *fields, const std::size_t length, const Taking &taking)
    {
      if (!is_list(value, length))
        return refuse<Whole>(value, taking);
      for (std::size_t i = 0; i < length; ++i)
        take(value.items[i], fields[i], taking);
    }

    template <class List>
    void take_list(const Value &value, List &list, const Taking &taking)
    {
      if (value.kind != Value::Kind::array)
        return refuse<List>(value, taking);
      for (const Value &item : value.items)
      {
        typename List::value_type field{};
        take(item, field, taking);
        list.push_back(field);
      }
    }

    // A table of exactly these keys, all of them points.
    template <class Whole>
    void take_points(const Value &value, const std::vector<std::string> &names,
                     const std::vector<Point *> &points, const Taking &taking)
    {
      bool complete = value.kind == Value::Kind::table && value.entries.size() == names.size();
      for (std::size_t i = 0; complete && i < names.size(); ++i)
        if (const Value *entry = value.find(names[i]))
          take(*entry, *points[i], taking);
        else
          complete = false;
      if (!complete)
        refuse<Whole>(value, taking);
    }
  } // namespace

  void complain_of_word(const Value &value, const std::vector<std::string> &known,
                        Complaints &complaints)
  {
    complaints.add(value, "read " + inline_text(value), listed(known),
                   value.kind == Value::Kind::text ? did_you_mean(value.text, known) : "");
  }

  void take(const Value &value, bool &field, const Taking &taking)
  {
    if (value.kind != Value::Kind::boolean)
      return refuse<bool>(value, taking);
    field = value.boolean;
  }

  void take(const Value &value, int &field, const Taking &taking)
  {
    if (value.kind != Value::Kind::integer ||
        std::abs(value.number) > std::numeric_limits<int>::max())
      return refuse<int>(value, taking);
    if (check_range(value, value.number, taking))
      field = static_cast<int>(value.integer);
  }

  void take(const Value &value, std::uint64_t &field, const Taking &taking)
  {
    if (value.kind != Value::Kind::integer || value.integer < 0)
      return refuse<std::uint64_t>(value, taking);
    field = static_cast<std::uint64_t>(value.integer);
  }

  void take(const Value &value, double &field, const Taking &taking)
  {
    if (!value.is_number())
      return refuse<double>(value, taking);
    if (check_range(value, value.number, taking))
      field = value.number;
  }

  void take(const Value &value, std::string &field, const Taking &taking)
  {
    if (value.kind != Value::Kind::text || value.text.empty())
      return refuse<std::string>(value, taking);
    field = value.text;
  }

  void take(const Value &value, Point &field, const Taking &taking)
  {
    take_each<Point>(value, field.data(), 2, taking);
  }

  void take(const Value &value, std::array<int, 2> &field, const Taking &taking)
  {
    take_each<std::array<int, 2>>(value, field.data(), 2, taking);
  }

  void take(const Value &value, std::vector<double> &field, const Taking &taking)
  {
    take_list(value, field, taking);
  }

  void take(const Value &value, std::vector<std::string> &field, const Taking &taking)
  {
    take_list(value, field, taking);
  }

  void take(const Value &value, Polyline &field, const Taking &taking)
  {
    if (value.kind != Value::Kind::array || value.items.size() < 3)
      return refuse<Polyline>(value, taking);
    for (const Value &item : value.items)
      take(item, field.emplace_back(Point::Zero()), taking);
  }

  void take(const Value &value, std::vector<Polyline> &field, const Taking &taking)
  {
    take_list(value, field, taking);
  }

  void take(const Value &value, Expression &field, const Taking &taking)
  {
    if (!value.is_number() && value.kind != Value::Kind::text)
      return refuse<Expression>(value, taking);
    field.place = value.place;
    field.text = value.is_number() ? number_text(value.number) : value.text;
    try
    {
      const Function function(field);
      if (function.is_constant())
        check_range(value, function({}), taking);
    }
    catch (const BadExpression &error)
    {
      taking.complaints.add(value, error.cause, allowed_in_expressions, "correct the expression");
    }
  }

  void take(const Value &value, VectorExpression &field, const Taking &taking)
  {
    take_each<VectorExpression>(value, field.data(), 2, taking);
  }

  void take(const Value &value, std::array<Expression, 4> &field, const Taking &taking)
  {
    take_each<std::array<Expression, 4>>(value, field.data(), 4, taking);
  }

  void take(const Value &value, std::array<std::optional<Expression>, 2> &field,
            const Taking &taking)
  {
    if (!is_list(value, 2))
      return refuse<std::array<std::optional<Expression>, 2>>(value, taking);
    for (std::size_t i = 0; i < 2; ++i)
      if (value.items[i].kind != Value::Kind::text || value.items[i].text != "free")
        take(value.items[i], field[i], taking);
  }

  void take(const Value &value, Segment &field, const Taking &taking)
  {
    std::array<Point, 2> ends{Point::Zero(), Point::Zero()};
    take_each<Segment>(value, ends.data(), 2, taking);
    field = {ends[0], ends[1]};
  }

  void take(const Value &value, Box &field, const Taking &taking)
  {
    take_points<Box>(value, {"lower", "upper"}, {&field.lower, &field.upper}, taking);
    if (!taking.complaints.about(value) && (field.upper.array() <= field.lower.array()).any())
      taking.complaints.add(value, "the box is empty", "lower below upper in x and y",
                            "exchange lower and upper, or widen the box");
  }

  void take(const Value &value, RegionProbe &field, const Taking &taking)
  {
    if (value.kind == Value::Kind::table)
      take(value, field.box, taking);
    else if (value.kind != Value::Kind::text || value.text != "all")
      refuse<RegionProbe>(value, taking);
  }

  void take(const Value &value, TipProbe &field, const Taking &taking)
  {
    field = {Point::Zero(), Point::Zero()};
    take_points<TipProbe>(value, {"origin", "direction"}, {&field.origin, &field.direction},
                          taking);
    if (!taking.complaints.about(value) && field.direction.norm() == 0.)
      taking.complaints.add(value, "the direction is zero", "a direction such as [0, 1]",
                            "say where the tip grows");
  }

  void take(const Value &value, std::array<Boundary, 4> &field, const Taking &taking)
  {
    if (value.kind == Value::Kind::table)
      for (const auto &[side, condition] : value.entries)
      {
        Value name = condition;
        name.kind = Value::Kind::text;
        name.text = side;
        Edge edge{};
        const std::size_t before = taking.complaints.count();
        take(name, edge, taking);
        if (taking.complaints.count() == before)
          take(condition, field.at(static_cast<std::size_t>(edge)), taking);
      }
    else
    {
      Boundary same{};
      take(value, same, taking);
      field.fill(same);
    }
  }
} // namespace scene
