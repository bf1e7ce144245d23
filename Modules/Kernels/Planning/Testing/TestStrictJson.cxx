#include "Planning/StrictJson.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{
using hasp::Json;
using hasp::StrictJson;

enum class Fruit
{
  Apple,
  Pear
};
constexpr std::pair<Fruit, const char*> Fruits[] = { { Fruit::Apple, "apple" },
  { Fruit::Pear, "pear" } };

/// What reading this object's members is refused with; empty if it is not.
std::string Refusal(const std::string& text, const std::function<void(const StrictJson&)>& read)
{
  try
  {
    const Json json = hasp::ParseJson(text, "basket");
    read(StrictJson(json, "basket", "rows[1]", { "a" }));
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

TEST(StrictJson, SaysWhereAndWhatButNothingOfTheText)
{
  const auto any = [](const StrictJson&) {};
  EXPECT_EQ(Refusal("{\"a\": Erika}", any), "basket: no JSON: a mistake at byte 7");
  EXPECT_EQ(
    Refusal("{\"a\": 1e999}", any), "basket: no JSON: a number is too large for any double");
  EXPECT_EQ(
    Refusal("{\"a\": 1, \"a\": 1}", any), "basket: no JSON: a key stands twice in one object");
  EXPECT_EQ(Refusal("{\"a\": {\"b\": 1}}", any), "");
  EXPECT_EQ(Refusal("{\"a\": [{\"b\": 1}, {\"b\": 1}]}", any), ""); // in two objects
  EXPECT_EQ(Refusal("[]", any), "basket: rows[1] must be an object");
  EXPECT_EQ(Refusal("{\"a\": 1, \"Erika\": 1}", any),
    "basket: a key of rows[1] is unknown, the nearest "
    "known is 'a'; mend its spelling or take it out");
  std::string deep = std::string(70, '[') + std::string(70, ']');
  EXPECT_EQ(Refusal("{\"a\": " + deep + "}", any), "basket: no JSON: it is nested deeper than 64");
}

TEST(StrictJson, AnUnknownKeyIsToldByTheNearestKnownAndItsLine)
{
  const std::string text = "{ \"rows\": [\n  { \"kerfMm\": 1, \"a\\\": \\\"b\": [{\"x\": 1}],\n"
                           "    \"Erika\":\n 2 } ],\n \"last\": 1 }";
  const auto refusal = [&](std::initializer_list<const char*> keys)
  {
    try
    {
      hasp::ReadJson(text, "basket",
        [&](const Json& json)
        {
          const StrictJson whole(json, "basket", "", { "rows", "last" });
          StrictJson(whole.List("rows")[0], "basket", "rows[0]", keys);
          return 0;
        });
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto told = [](const std::string& key, int line)
  {
    return "basket: a key of rows[0] is unknown, the nearest known is '" + key +
           "'; mend its spelling or take it out (line " + std::to_string(line) + ")";
  };
  EXPECT_EQ(refusal({ "kerfMm", "a\": \"b", "Erika" }), "");
  EXPECT_EQ(refusal({ "kerfMm", "a\": \"b", "depthMm", "erica" }), told("erica", 3));
  EXPECT_EQ(refusal({ "Kerfmm", "gapMm", "a\": \"b", "Erika" }), told("Kerfmm", 2));
}

TEST(StrictJson, MembersAreOfTheirKind)
{
  const std::string begin = "basket: rows[1].a ";
  const auto number = [](const StrictJson& o) { o.Number("a"); };
  EXPECT_EQ(Refusal("{}", number), begin + "is missing");
  EXPECT_EQ(Refusal("{\"a\": \"1\"}", number), begin + "must be a number");
  const auto count = [](const StrictJson& o) { o.Count("a", 1, 9); };
  EXPECT_EQ(Refusal("{\"a\": 9}", count), "");
  for (const char* bad : { "0", "10", "-1", "1.0", "99999999999999999999999", "true" })
    EXPECT_EQ(Refusal("{\"a\": " + std::string(bad) + "}", count),
      begin + "must be a whole number in [1, 9]");
  EXPECT_EQ(Refusal("{\"a\": 1}", [](const StrictJson& o) { o.Flag("a"); }),
    begin + "must be true or false");
  EXPECT_EQ(
    Refusal("{\"a\": 1}", [](const StrictJson& o) { o.Text("a"); }), begin + "must be text");
  const auto vector = [](const StrictJson& o) { o.Vector("a"); };
  EXPECT_EQ(Refusal("{\"a\": [1, 2]}", vector), begin + "must be three numbers");
  EXPECT_EQ(Refusal("{\"a\": [1, 2, null]}", vector), begin + "must be a number");
  EXPECT_EQ(Refusal("{\"a\": [[1, 2, 3], 4]}", [](const StrictJson& o) { o.Vectors("a"); }),
    "basket: rows[1].a[1] must be three numbers");
  EXPECT_EQ(
    Refusal("{\"a\": {}}", [](const StrictJson& o) { o.List("a"); }), begin + "must be a list");
  EXPECT_EQ(Refusal("{\"a\": [1, 2, 3]}", [](const StrictJson& o) { o.List("a", 2); }),
    begin + "has 3 entries, at most 2 are read");
  EXPECT_EQ(Refusal("{\"a\": \"Erika\"}", [](const StrictJson& o) { o.Named("a", Fruits); }),
    begin + "must be apple or pear");
  EXPECT_EQ(Refusal("{\"a\": \"pear\"}",
              [](const StrictJson& o) { EXPECT_EQ(o.Named("a", Fruits), Fruit::Pear); }),
    "");
}

TEST(StrictJson, TextThatIsNoUtf8IsNotWritten)
{
  try
  {
    hasp::FormatJson({ { "a", "\xff" } }, "basket");
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(), "basket: a text is not UTF-8");
  }
}

} // namespace
