// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/quantity.h"
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <udunits2.h>

namespace ballonet::studies
{
namespace
{

struct FreeUnit {
  void operator()(ut_unit *unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter *converter) const { cv_free(converter); }
};
struct FreeSystem {
  void operator()(ut_system *system) const { ut_free_system(system); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

/// The unit database, read once. udunits keeps its status in global variables, hence the lock around every use.
class UnitSystem
{
public:
  static UnitSystem &instance()
  {
    static UnitSystem system;
    return system;
  }

  /// `value`, given in unit `from`, in unit `to`; throws QuantityError naming `text`.
  double convert(double value, const std::string &from, const std::string &to)
  {
    const std::lock_guard lock(mutex_);
    const Unit source(ut_parse(system_.get(), from.c_str(), UT_UTF8));
    if (!source)
      throw QuantityError("an existing unit: \"" + from + "\" is unknown; use " + to + " or a unit of the same kind");
    const Unit target(ut_parse(system_.get(), to.c_str(), UT_UTF8));
    if (!target)
      throw std::logic_error("a field asks for the unit \"" + to + "\", which does not exist");
    const Converter converter(ut_get_converter(source.get(), target.get()));
    if (!converter)
      throw QuantityError("a unit of the same kind as " + to + ": \"" + from + "\" measures something else");
    return cv_convert_double(converter.get(), value);
  }

private:
  UnitSystem()
  {
    ut_set_error_message_handler(ut_ignore);
    system_.reset(ut_read_xml(nullptr));
    if (!system_)
      throw std::runtime_error("the unit database of udunits2 cannot be read");
    const Unit degree(ut_parse(system_.get(), "degree", UT_UTF8));
    ut_map_name_to_unit("deg", UT_ASCII, degree.get());
  }

  std::mutex mutex_;
  std::unique_ptr<ut_system, FreeSystem> system_;
};

std::string_view trim(std::string_view text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A unit is made of names, exponents, "/", "*", "^" and perhaps a leading "1/". udunits would take more: "mm 3" is
/// three millimetres to it, and "s from 3" a clock; here both are slips of the pen.
bool looks_like_unit(std::string_view unit)
{
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const char c = unit[i], before = i == 0 ? '\0' : unit[i - 1];
    const bool digit = c >= '0' && c <= '9', letter = std::isalpha(static_cast<unsigned char>(c)) || (c & 0x80);
    const bool leading_one = i == 0 && unit.starts_with("1/");
    const bool exponent = before == '^' || before == '-' || std::isalnum(static_cast<unsigned char>(before));
    if (digit ? !leading_one && !exponent : !letter && std::string_view("/*^-() %.").find(c) == std::string_view::npos)
      return false;
  }
  return true;
}

double rounded_to_15_digits(double value)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.15g", value);
  return std::strtod(text.data(), nullptr);
}

} // namespace

double parse_quantity(std::string_view text, const std::string &unit)
{
  std::string_view rest = trim(text);
  if (rest.starts_with('+'))
    rest.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  const std::string example = unit == "1" ? "a plain number" : "a number with a unit, such as \"1.5 " + unit + "\"";
  if (error == std::errc::invalid_argument)
    throw QuantityError(example);
  if (error != std::errc{} || !std::isfinite(value))
    throw QuantityError(example + "; the number must be finite");
  const std::string given(trim(rest.substr(static_cast<std::size_t>(end - rest.data()))));
  if (given == unit || (given.empty() && unit == "1"))
    return value;
  if (given.empty())
    throw QuantityError(example + "; the unit is missing");
  if (!looks_like_unit(given))
    throw QuantityError(example + "; \"" + given + "\" is not a unit");
  const double converted = rounded_to_15_digits(UnitSystem::instance().convert(value, given, unit));
  if (!std::isfinite(converted))
    throw QuantityError(example + "; the number must be finite");
  return converted;
}

std::string format_number(double value)
{
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  std::string result(text.data(), end);
  if (result.find_first_of(".en") == std::string::npos)
    result += ".0";
  return result;
}

std::string format_quantity(double value, const std::string &unit)
{
  return unit == "1" ? format_number(value) : format_number(value) + " " + unit;
}

} // namespace ballonet::studies
