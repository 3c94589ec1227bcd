#include "wend/base/options.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

namespace wend {
namespace {

enum class Colour { red, light_green };

constexpr std::array<Choice<Colour>, 2> choice_names(Colour) {
  return {{{"red", Colour::red}, {"light-green", Colour::light_green}}};
}

struct BoatOptions {
  bool sail = true;
  std::int64_t oars = 4;
  double length = 5.5;
  Colour colour = Colour::light_green;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"sail", "has it a sail?"}, self.sail);
    field({"oars", "how many oars"}, self.oars, {0, 100});
    field({"length", "metres from end to end", {"loa", "overall"}}, self.length, {1, 60});
    field({"colour", "what it is painted with"}, self.colour);
  }

  friend bool operator==(const BoatOptions&, const BoatOptions&) = default;
};

struct RenamedOptions {
  std::int64_t crew = 2;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({.name = "crew", .help = "number of people", .former = "hands"}, self.crew, {1, 9});
  }
};

struct NoOptions {
  template <class Self, class Field>
  static void fields(Self&, Field&&) {}
};

std::string error_of(const OptionValues& values) {
  const auto parsed = parse_options<BoatOptions>(values);
  return parsed ? "no error" : parsed.error().message;
}

TEST(OptionParser, TakesAFormerNameThatIsNotShown) {
  const auto crew_of = [](const OptionValues& values) {
    const auto parsed = parse_options<RenamedOptions>(values);
    return parsed ? std::to_string(parsed->crew) : parsed.error().message;
  };
  EXPECT_EQ(crew_of({{"hands", "5"}}), "5");
  EXPECT_EQ(crew_of({{"hands", "5"}, {"crew", "6"}}), "6") << "the last one counts";
  EXPECT_EQ(crew_of({{"crew", "6"}, {"hands", "5"}}), "5") << "the last one counts";
  EXPECT_EQ(crew_of({{"hands", "x"}}), "option 'hands': 'x' is not a whole number");
  EXPECT_EQ(crew_of({{"hand", "5"}}), "unknown option 'hand': choose from crew");
  EXPECT_NE(crew_of({{"", "5"}}), "5");
  const auto schema = option_schema<RenamedOptions>();
  EXPECT_TRUE(schema[0].aliases.empty());
  EXPECT_EQ(schema[0].former, "hands");
}

TEST(OptionSchema, ListsTheFieldsInOrderWithTheirDefaults) {
  const auto schema = option_schema<BoatOptions>();
  ASSERT_EQ(schema.size(), 4U);

  EXPECT_EQ(schema[0].name, "sail");
  EXPECT_EQ(schema[0].kind, OptionKind::flag);
  EXPECT_EQ(schema[0].default_value, "true");
  EXPECT_EQ(schema[0].help, "has it a sail?");
  EXPECT_TRUE(schema[0].aliases.empty());

  EXPECT_EQ(schema[1].name, "oars");
  EXPECT_EQ(schema[1].kind, OptionKind::integer);
  EXPECT_EQ(schema[1].default_value, "4");
  EXPECT_EQ(schema[1].least, 0);
  EXPECT_EQ(schema[1].greatest, 100);

  EXPECT_EQ(schema[2].name, "length");
  EXPECT_EQ(schema[2].aliases, (std::vector<std::string>{"loa", "overall"}));
  EXPECT_EQ(schema[2].kind, OptionKind::number);
  EXPECT_EQ(schema[2].default_value, "5.5");
  EXPECT_EQ(schema[2].least, 1);
  EXPECT_EQ(schema[2].greatest, 60);

  EXPECT_EQ(schema[3].name, "colour");
  EXPECT_EQ(schema[3].kind, OptionKind::choice);
  EXPECT_EQ(schema[3].default_value, "light-green");
  EXPECT_EQ(schema[3].choices, (std::vector<std::string>{"red", "light-green"}));

  EXPECT_TRUE(option_schema<NoOptions>().empty());
}

TEST(OptionSchema, DefaultsAreValuesThatTheOptionTakes) {
  for (const OptionInfo& option : option_schema<BoatOptions>()) {
    const auto parsed = parse_options<BoatOptions>({{option.name, option.default_value}});
    ASSERT_TRUE(parsed.has_value()) << option.name;
    EXPECT_EQ(*parsed, BoatOptions{}) << option.name;
  }
}

TEST(OptionSchema, FindsTheSameFaultsAsTheParser) {
  for (const OptionInfo& option : option_schema<BoatOptions>()) {
    for (const std::string text :
         {"", "true", "1", "0.5", "60.5", "1e3", "-1", "red", "blue", "nan"}) {
      const std::string fault = option_text::fault_of(option, text);
      const std::string expected =
          fault.empty() ? "no error" : option_text::option_error(option.name, fault).message;
      EXPECT_EQ(error_of({{option.name, text}}), expected) << option.name << " = " << text;
    }
  }
}

TEST(OptionKindNames, AreWords) {
  EXPECT_EQ(to_string(OptionKind::flag), "flag");
  EXPECT_EQ(to_string(OptionKind::integer), "integer");
  EXPECT_EQ(to_string(OptionKind::number), "number");
  EXPECT_EQ(to_string(OptionKind::choice), "choice");
}

TEST(ParseOptions, WithoutValuesGivesTheDefaults) {
  EXPECT_EQ(parse_options<BoatOptions>({}).value(), BoatOptions{});
  EXPECT_TRUE(parse_options<NoOptions>({}).has_value());
}

TEST(ParseOptions, SetsWhatIsGivenAndNothingElse) {
  const auto parsed = parse_options<BoatOptions>(
      {{"sail", "false"}, {"oars", "12"}, {"length", "7.25"}, {"colour", "red"}});
  EXPECT_EQ(parsed.value(), (BoatOptions{false, 12, 7.25, Colour::red}));
  EXPECT_EQ(parse_options<BoatOptions>({{"oars", "12"}}).value(),
            (BoatOptions{true, 12, 5.5, Colour::light_green}));
}

TEST(ParseOptions, TakesAnAliasForTheName) {
  EXPECT_EQ(parse_options<BoatOptions>({{"loa", "9"}}).value().length, 9);
  EXPECT_EQ(parse_options<BoatOptions>({{"overall", "9"}}).value().length, 9);
}

TEST(ParseOptions, LetsTheLastOneCount) {
  EXPECT_EQ(
      parse_options<BoatOptions>({{"oars", "1"}, {"sail", "false"}, {"oars", "2"}}).value().oars,
      2);
  EXPECT_EQ(parse_options<BoatOptions>({{"loa", "9"}, {"length", "8"}}).value().length, 8);
  EXPECT_EQ(parse_options<BoatOptions>({{"length", "8"}, {"loa", "9"}}).value().length, 9);
}

RC_GTEST_PROP(ParseOptions, TakesExactlyTheNumbersInRange, (double number)) {
  const auto parsed = parse_options<BoatOptions>({{"length", format_number(number)}});
  RC_ASSERT(parsed.has_value() == (number >= 1 && number <= 60));
  if (parsed) RC_ASSERT(parsed->length == number);
}

RC_GTEST_PROP(ParseOptions, TakesExactlyTheIntegersInRange, ()) {
  const auto number = *rc::gen::inRange<std::int64_t>(-300, 300);
  const auto parsed = parse_options<BoatOptions>({{"oars", std::to_string(number)}});
  RC_ASSERT(parsed.has_value() == (number >= 0 && number <= 100));
  if (parsed) RC_ASSERT(parsed->oars == number);
}

TEST(ParseOptions, TakesBothEndsOfARange) {
  EXPECT_EQ(error_of({{"oars", "0"}}), "no error");
  EXPECT_EQ(error_of({{"oars", "100"}}), "no error");
  EXPECT_EQ(error_of({{"length", "1"}}), "no error");
  EXPECT_EQ(error_of({{"length", "60"}}), "no error");
}

TEST(ParseOptions, SaysWhatIsWrongWithAValue) {
  EXPECT_EQ(error_of({{"sail", "yes"}}), "option 'sail': 'yes' is neither true nor false");
  EXPECT_EQ(error_of({{"oars", "101"}}), "option 'oars': '101' is not between 0 and 100");
  EXPECT_EQ(error_of({{"oars", "-1"}}), "option 'oars': '-1' is not between 0 and 100");
  EXPECT_EQ(error_of({{"oars", "99999999999999999999"}}),
            "option 'oars': '99999999999999999999' is not between 0 and 100");
  EXPECT_EQ(error_of({{"oars", "1.5"}}), "option 'oars': '1.5' is not a whole number");
  EXPECT_EQ(error_of({{"oars", ""}}), "option 'oars': '' is not a whole number");
  EXPECT_EQ(error_of({{"length", "long"}}), "option 'length': 'long' is not a number");
  EXPECT_EQ(error_of({{"length", "nan"}}), "option 'length': 'nan' is not a number");
  EXPECT_EQ(
      error_of({{"length", "5,5"}}),
      "option 'length': '5,5' is not a number: the decimal point is a dot, did you mean 5.5?");
  EXPECT_EQ(error_of({{"length", "1,2,3"}}), "option 'length': '1,2,3' is not a number");
  EXPECT_EQ(error_of({{"length", "1e308"}}), "option 'length': '1e308' is not between 1 and 60");
  EXPECT_EQ(error_of({{"length", "-1e999"}}), "option 'length': '-1e999' is not between 1 and 60");
  EXPECT_EQ(error_of({{"length", "1e-999"}}), "option 'length': '1e-999' is not a number");
  EXPECT_EQ(error_of({{"length", "inf"}}), "option 'length': 'inf' is not between 1 and 60");
  EXPECT_EQ(error_of({{"length", "0.5"}}), "option 'length': '0.5' is not between 1 and 60");
  EXPECT_EQ(error_of({{"colour", "blue"}}),
            "option 'colour': 'blue' is not one of red, light-green");
}

TEST(ParseOptions, NamesTheOptionAsItWasTyped) {
  EXPECT_EQ(error_of({{"loa", "100"}}), "option 'loa': '100' is not between 1 and 60");
}

TEST(ParseOptions, ReportsABadValueEvenIfAGoodOneFollows) {
  EXPECT_EQ(error_of({{"oars", "many"}, {"oars", "2"}}),
            "option 'oars': 'many' is not a whole number");
}

TEST(ParseOptions, SuggestsTheNameThatWasMeant) {
  EXPECT_EQ(error_of({{"lenght", "6"}}), "unknown option 'lenght': did you mean 'length'?");
  EXPECT_EQ(error_of({{"colour", "blue"}, {"oar", "6"}}),
            "unknown option 'oar': did you mean 'oars'?");
}

TEST(ParseOptions, ListsTheNamesWhereNoneIsNear) {
  const std::string error = error_of({{"engine", "6"}});
  EXPECT_EQ(error.find("unknown option 'engine': choose from sail, oars, length"), 0U) << error;
  EXPECT_EQ(parse_options<NoOptions>({{"engine", "6"}}).error().message,
            "unknown option 'engine': there are no options");
}

TEST(ChoiceName, IsTheInverseOfParsing) {
  EXPECT_EQ(choice_name(Colour::red), "red");
  EXPECT_EQ(choice_name(Colour::light_green), "light-green");
}

}  // namespace
}  // namespace wend
