#include "scene/read_value.h"

#include <cmath>

#include "scene/expression.h"

namespace scene
{
  namespace
  {
    template <class T>
    void refuse(const Value &value, const ReadContext &context)
    {
      const std::string range = context.allowed.range.text();
      context.errors.add(value, "read " + inline_text(value),
                         Kind<T>::text() + (range.empty() ? "" : ", " + range),
                         "write it that way");
    }

    // What numbers a key takes, said where one is outside.
    bool check_range(const Value &value, const double number, const ReadContext &context)
    {
      const Range &range = context.allowed.range;
      if (std::isfinite(number) && range.holds(number))
        return true;
      const std::string unit = unit_text(context.allowed.dimension, Units::si);
      context.errors.add(
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
    void read_each(const Value &value, Each *fields, const std::size_t length,
                   const ReadContext &context)
    {
      if (!is_list(value, length))
        return refuse<Whole>(value, context);
      for (std::size_t i = 0; i < length; ++i)
        read_value(value.items[i], fields[i], context);
    }

    template <class List>
    void read_list(const Value &value, List &list, const ReadContext &context)
    {
      if (value.kind != Value::Kind::array)
        return refuse<List>(value, context);
      for (const Value &item : value.items)
      {
        typename List::value_type field{};
        read_value(item, field, context);
        list.push_back(field);
      }
    }

    // A table of exactly these keys, all of them points.
    template <class Whole>
    void read_points(const Value &value, const std::vector<std::string> &names,
                     const std::vector<Point *> &points, const ReadContext &context)
    {
      bool complete = value.kind == Value::Kind::table && value.entries.size() == names.size();
      for (std::size_t i = 0; complete && i < names.size(); ++i)
        if (const Value *entry = value.find(names[i]))
          read_value(*entry, *points[i], context);
        else
          complete = false;
      if (!complete)
        refuse<Whole>(value, context);
    }
  } // namespace

  void add_unknown_word(const Value &value, const std::vector<std::string> &known,
                        ErrorList &errors)
  {
    errors.add(value, "read " + inline_text(value), comma_separated(known),
               value.kind == Value::Kind::text ? did_you_mean(value.text, known) : "");
  }

  void read_value(const Value &value, bool &field, const ReadContext &context)
  {
    if (value.kind != Value::Kind::boolean)
      return refuse<bool>(value, context);
    field = value.boolean;
  }

  void read_value(const Value &value, int &field, const ReadContext &context)
  {
    if (value.kind != Value::Kind::integer ||
        std::abs(value.number) > std::numeric_limits<int>::max())
      return refuse<int>(value, context);
    if (check_range(value, value.number, context))
      field = static_cast<int>(value.integer);
  }

  void read_value(const Value &value, std::uint64_t &field, const ReadContext &context)
  {
    if (value.kind != Value::Kind::integer || value.integer < 0)
      return refuse<std::uint64_t>(value, context);
    field = static_cast<std::uint64_t>(value.integer);
  }

  void read_value(const Value &value, double &field, const ReadContext &context)
  {
    if (!value.is_number())
      return refuse<double>(value, context);
    if (check_range(value, value.number, context))
      field = value.number;
  }

  void read_value(const Value &value, std::string &field, const ReadContext &context)
  {
    if (value.kind != Value::Kind::text || value.text.empty())
      return refuse<std::string>(value, context);
    field = value.text;
  }

  void read_value(const Value &value, Point &field, const ReadContext &context)
  {
    read_each<Point>(value, field.data(), 2, context);
  }

  void read_value(const Value &value, std::array<int, 2> &field, const ReadContext &context)
  {
    read_each<std::array<int, 2>>(value, field.data(), 2, context);
  }

  void read_value(const Value &value, std::vector<double> &field, const ReadContext &context)
  {
    read_list(value, field, context);
  }

  void read_value(const Value &value, std::vector<std::string> &field, const ReadContext &context)
  {
    read_list(value, field, context);
  }

  void read_value(const Value &value, Polyline &field, const ReadContext &context)
  {
    if (value.kind != Value::Kind::array || value.items.size() < 3)
      return refuse<Polyline>(value, context);
    for (const Value &item : value.items)
      read_value(item, field.emplace_back(Point::Zero()), context);
  }

  void read_value(const Value &value, std::vector<Polyline> &field, const ReadContext &context)
  {
    read_list(value, field, context);
  }

  void read_value(const Value &value, Expression &field, const ReadContext &context)
  {
    if (!value.is_number() && value.kind != Value::Kind::text)
      return refuse<Expression>(value, context);
    field.place = value.place;
    field.text = value.is_number() ? number_text(value.number) : value.text;
    try
    {
      const Function function(field);
      if (function.is_constant())
        check_range(value, function({}), context);
    }
    catch (const BadExpression &error)
    {
      context.errors.add(value, error.cause, allowed_in_expressions, "correct the expression");
    }
  }

  void read_value(const Value &value, VectorExpression &field, const ReadContext &context)
  {
    read_each<VectorExpression>(value, field.data(), 2, context);
  }

  void read_value(const Value &value, std::array<Expression, 4> &field, const ReadContext &context)
  {
    read_each<std::array<Expression, 4>>(value, field.data(), 4, context);
  }

  void read_value(const Value &value, std::array<std::optional<Expression>, 2> &field,
                  const ReadContext &context)
  {
    if (!is_list(value, 2))
      return refuse<std::array<std::optional<Expression>, 2>>(value, context);
    for (std::size_t i = 0; i < 2; ++i)
      if (value.items[i].kind != Value::Kind::text || value.items[i].text != "free")
        read_value(value.items[i], field[i], context);
  }

  void read_value(const Value &value, Segment &field, const ReadContext &context)
  {
    std::array<Point, 2> ends{Point::Zero(), Point::Zero()};
    read_each<Segment>(value, ends.data(), 2, context);
    field = {ends[0], ends[1]};
  }

  void read_value(const Value &value, Box &field, const ReadContext &context)
  {
    read_points<Box>(value, {"lower", "upper"}, {&field.lower, &field.upper}, context);
    if (!context.errors.about(value) && (field.upper.array() <= field.lower.array()).any())
      context.errors.add(value, "the box is empty", "lower below upper in x and y",
                         "exchange lower and upper, or widen the box");
  }

  void read_value(const Value &value, RegionProbe &field, const ReadContext &context)
  {
    if (value.kind == Value::Kind::table)
      read_value(value, field.box, context);
    else if (value.kind != Value::Kind::text || value.text != "all")
      refuse<RegionProbe>(value, context);
  }

  void read_value(const Value &value, TipProbe &field, const ReadContext &context)
  {
    field = {Point::Zero(), Point::Zero()};
    read_points<TipProbe>(value, {"origin", "direction"}, {&field.origin, &field.direction},
                          context);
    if (!context.errors.about(value) && field.direction.norm() == 0.)
      context.errors.add(value, "the direction is zero", "a direction such as [0, 1]",
                         "say where the tip grows");
  }

  void read_value(const Value &value, std::array<Boundary, 4> &field, const ReadContext &context)
  {
    if (value.kind == Value::Kind::table)
      for (const auto &[side, condition] : value.entries)
      {
        Value name = condition;
        name.kind = Value::Kind::text;
        name.text = side;
        Edge edge{};
        const std::size_t before = context.errors.count();
        read_value(name, edge, context);
        if (context.errors.count() == before)
          read_value(condition, field.at(static_cast<std::size_t>(edge)), context);
      }
    else
    {
      Boundary same{};
      read_value(value, same, context);
      field.fill(same);
    }
  }
} // namespace scene
