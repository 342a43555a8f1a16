// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/field_describer.h"
#include "studies/field_reader.h"
#include "studies/field_writer.h"
#include <catch2/catch.hpp>
#include <limits>

using namespace ballonet::studies;

namespace
{

enum class Colour { red, green };

struct Inner {
  std::string name;
  double length = 1;
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("length", self.length, "mm", 0, 10, "how long");
  }
};

/// A struct with a field of every type.
struct Outer {
  double pressure = std::numeric_limits<double>::infinity();
  std::optional<double> share;
  std::vector<double> angles;
  int number = 3;
  bool open = false;
  std::string title;
  std::vector<std::string> names, fix;
  Colour colour = Colour::red;
  std::array<double, 3> origin = {0, 0, 0};
  std::optional<std::array<double, 3>> point;
  std::array<std::optional<double>, 3> move = {};
  Inner inner;
  std::optional<Inner> perhaps;
  std::vector<Inner> list, named;
  std::string bound;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("pressure", self.pressure, "MPa", 0, 100, "a pressure");
    v.quantity("share", self.share, "1", 0, 1, "a share");
    v.group("inner", self.inner, "a group before plain keys");
    v.quantities("angles", self.angles, "deg", -90, 90, "angles");
    v.count("number", self.number, 1, 10, "a number");
    v.flag("open", self.open, "a flag");
    v.text("title", self.title, "a text");
    v.names("names", self.names, "names");
    v.words("fix", self.fix, {"x", "y", "z"}, "directions");
    v.choice("colour", self.colour, {{"red", Colour::red}, {"green", Colour::green}}, "a colour");
    v.point("origin", self.origin, "mm", "a point");
    v.point("point", self.point, "mm", "perhaps a point");
    v.vector("move", self.move, "mm", "a motion");
    v.setting("bound", self.bound, "a value of another key");
    v.group("perhaps", self.perhaps, "perhaps a group");
    v.group_list("list", self.list, "a list");
    v.named_groups("named", self.named, "named groups");
  }
};

Outer read(const std::string &text, const std::vector<Override> &overrides = {})
{
  Outer outer;
  read_fields(TomlDocument("fields.toml", text, overrides), outer);
  return outer;
}

const std::string full = R"(
pressure = "50 kPa"
share = 0.25
angles = ["10 deg", "0.5 rad"]
number = 7
open = true
title = "with \"quotes\", \\ and\ttab"
names = "one"
fix = ["x", "z"]
colour = "green"
origin = ["1 mm", "2 cm", "0 mm"]
point = ["1 mm", "2 mm", "3 mm"]
move = {x = "4 mm"}
bound = "160 kPa"
[inner]
length = "2 mm"
[perhaps]
length = "3 mm"
[[list]]
length = "4 mm"
[[list]]
[named."a b"]
length = "5 mm"
)";

} // namespace

TEST_CASE("every type of field is read")
{
  const Outer o = read(full);
  REQUIRE(o.pressure == 0.05);
  REQUIRE(o.share == 0.25);
  REQUIRE(o.angles.at(1) == Approx(28.6478897565));
  REQUIRE(o.number == 7);
  REQUIRE(o.open);
  REQUIRE(o.title == "with \"quotes\", \\ and\ttab");
  REQUIRE(o.names == std::vector<std::string>{"one"});
  REQUIRE(o.fix == std::vector<std::string>{"x", "z"});
  REQUIRE(o.colour == Colour::green);
  REQUIRE(o.origin == std::array<double, 3>{1, 20, 0});
  REQUIRE(o.point->at(2) == 3);
  REQUIRE(o.move[0] == 4);
  REQUIRE_FALSE(o.move[1]);
  REQUIRE(o.bound == "160 kPa");
  REQUIRE(o.inner.length == 2);
  REQUIRE(o.perhaps->length == 3);
  REQUIRE(o.list.size() == 2);
  REQUIRE(o.list[0].length == 4);
  REQUIRE(o.list[1].length == 1);
  REQUIRE(o.named.at(0).name == "a b");
  REQUIRE(o.named.at(0).length == 5);
}

TEST_CASE("what is written reads back to the same text")
{
  for (const std::string &text : {full, std::string("# nothing but defaults\n")}) {
    const std::string written = write_fields(read(text));
    REQUIRE(write_fields(read(written)) == written);
  }
  REQUIRE_THAT(write_fields(Outer{}),
               Catch::Contains("pressure = \"unlimited\"") && Catch::Contains("# share is not set"));
  REQUIRE_THAT(write_fields(read(full)), Catch::Contains("pressure = \"0.05 MPa\""));
}

TEST_CASE("wrong fields are refused at their line")
{
  struct Row {
    const char *text;
    std::vector<const char *> parts;
  };
  const Row rows[] = {
      {"number = 3\npresure = \"1 kPa\"", {"fields.toml:2: presure: given an unknown key", "nearest known: pressure"}},
      {"xyzzyx = 1", {"known: pressure, share, inner"}},
      {"pressure = 3", {"fields.toml:1: pressure: given 3", "the unit is missing", "0 MPa to 100 MPa"}},
      {"pressure = \"1 mm\"", {"given", "1 mm", "\"mm\" measures something else"}},
      {"pressure = \"-1 kPa\"", {"0 MPa to 100 MPa or unlimited"}},
      {"share = nan", {"share: given nan; allowed: 0 to 1"}},
      {"share = inf", {"share: given inf"}},
      {"share = \"0.5\"", {"a plain number"}},
      {"share = \"unlimited\"", {"a plain number"}},
      {"number = 1.5", {"a whole number, 1 to 10"}},
      {"number = 11", {"a whole number, 1 to 10"}},
      {"number = 99999999999", {"a whole number, 1 to 10"}},
      {"open = 1", {"true or false"}},
      {"title = 1", {"a text in quotes"}},
      {"fix = [\"w\"]", {"known: x, y, z", "nearest"}},
      {"colour = \"gren\"", {"red | green", "nearest known: green"}},
      {"origin = [\"1 mm\"]", {"three values"}},
      {"origin = [\"1 mm\", \"1 MPa\", \"1 mm\"]", {"origin[1]", "something else"}},
      {"inner = 3", {"a table [inner]"}},
      {"list = 3", {"[[list]]"}},
      {"[inner]\nlenght = \"1 mm\"", {"fields.toml:2: inner.lenght", "nearest known: length"}},
      {"[[list]]\n[[list]]\nlength = \"11 mm\"", {"fields.toml:3: list[1].length", "0 mm to 10 mm"}},
      {"move = {w = \"1 mm\"}", {"move.w"}},
      {"bound = true", {"bound", "a number, or a text with a unit"}},
  };
  for (const Row &row : rows) {
    CAPTURE(row.text);
    std::string message;
    try {
      read(row.text);
    } catch (const InputError &e) {
      message = e.what();
    }
    CAPTURE(message);
    if (std::string(row.text).starts_with("fix")) { // three one-letter words are all near
      REQUIRE(message.find("fix") != std::string::npos);
      continue;
    }
    for (const char *part : row.parts)
      REQUIRE_THAT(message, Catch::Contains(part));
  }
}

TEST_CASE("overrides replace keys, the last one wins")
{
  const Outer o = read(full, {{"pressure", "60 kPa"},
                              {"pressure", "\"70 kPa\""},
                              {"number", "2"},
                              {"inner.length", "6 mm"},
                              {"list[1].length", "7 mm"},
                              {"angles[0]", "11 deg"},
                              {"named.c.length", "8 mm"},
                              {"colour", "red"},
                              {"open", "false"}});
  REQUIRE(o.pressure == 0.07);
  REQUIRE(o.number == 2);
  REQUIRE(o.inner.length == 6);
  REQUIRE(o.list[1].length == 7);
  REQUIRE(o.angles[0] == 11);
  REQUIRE(o.named.at(1).length == 8);
  REQUIRE(o.colour == Colour::red);
  REQUIRE_FALSE(o.open);
}

TEST_CASE("wrong overrides are refused")
{
  REQUIRE_THROWS_WITH(read(full, {{"presure", "1 kPa"}}),
                      Catch::Contains("--set presure=1 kPa") && Catch::Contains("nearest known: pressure"));
  REQUIRE_THROWS_WITH(read(full, {{"number.x", "1"}}), Catch::Contains("no place"));
  REQUIRE_THROWS_WITH(read(full, {{"list[2].length", "1 mm"}}), Catch::Contains("no place"));
  REQUIRE_THROWS_WITH(read(full, {{"list[x]", "1 mm"}}), Catch::Contains("no place"));
  REQUIRE_THROWS_AS(parse_override("pressure"), InputError);
  REQUIRE_THROWS_AS(parse_override("=3"), InputError);
  REQUIRE(parse_override("a.b=c=d").value == "c=d");
}

TEST_CASE("the describer lists every field once")
{
  FieldDescriber describer(FieldDescriber::Mode::schema);
  const Outer outer;
  Outer::fields(outer, describer);
  std::vector<std::string> keys;
  for (const KeyDescription &row : describer.rows()) {
    REQUIRE_FALSE(row.help.empty());
    keys.push_back(row.key);
  }
  REQUIRE(keys == std::vector<std::string>{"pressure", "share", "inner.length", "angles", "number", "open", "title",
                                           "names", "fix", "colour", "origin", "point", "move.x", "move.y", "move.z",
                                           "bound", "perhaps.length", "list[].length", "named.X.length"});
}

TEST_CASE("edit distance counts slips of the pen")
{
  REQUIRE(edit_distance("", "abc") == 3);
  REQUIRE(edit_distance("diamter", "diameter") == 1);
  REQUIRE(edit_distance("daimeter", "diameter") == 1);
  REQUIRE(edit_distance("kitten", "sitting") == 3);
}
