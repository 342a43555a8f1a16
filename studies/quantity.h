// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace ballonet::studies
{

/// A text that is not the asked quantity. what() says what is allowed, such as "a pressure in MPa or a unit of the same
/// kind".
class QuantityError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The number in `text` ("160 kPa"), converted to `unit` ("MPa"). Conversions are rounded to 15 significant digits, so
/// that 160 kPa is 0.16 MPa and not its neighbour; a text already in `unit` is taken as it stands.
/// Throws QuantityError for a missing, unknown or incompatible unit, a number that is not finite, and anything left
/// over.
double parse_quantity(std::string_view text, const std::string &unit);

/// The shortest text that parse_quantity() reads back to the same number: "0.16 MPa"; without unit for unit "1".
std::string format_quantity(double value, const std::string &unit);

/// The shortest text of a number that reads back to the same double; always with a point or exponent.
std::string format_number(double value);

} // namespace ballonet::studies
