#include "Devices/Drivers/SpaceMouse/SpaceMouseModels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>

namespace
{

using namespace hasp;

HidCollection MultiAxis(std::uint16_t vendor, std::uint16_t product, std::string name = {})
{
  return { "node", vendor, product, 1, 8, std::move(name) };
}

TEST(SpaceMouseModels, EveryListedOneIsFoundByItsMultiAxisCollectionAlone)
{
  ASSERT_EQ(SpaceMouseModels().size(), 22u);
  std::set<std::pair<int, int>> all;
  for (const SpaceMouseModel& model : SpaceMouseModels())
  {
    EXPECT_TRUE(all.emplace(model.vendor, model.product).second) << model.name;
    HidCollection collection = MultiAxis(model.vendor, model.product);
    EXPECT_EQ(SpaceMouseOf(collection), &model) << model.name;
    collection.usage = 2; // a mouse
    EXPECT_EQ(SpaceMouseOf(collection), nullptr) << model.name;
    collection.usage = 8;
    collection.usagePage = 0xff00;
    EXPECT_EQ(SpaceMouseOf(collection), nullptr) << model.name;
  }
}

TEST(SpaceMouseModels, MiceAndKeyboardsAreSkipped)
{
  EXPECT_EQ(SkippedSpaceMouseProducts().size(), 11u);
  for (const std::uint16_t product : SkippedSpaceMouseProducts())
    EXPECT_EQ(SpaceMouseOf(MultiAxis(0x256f, product)), nullptr) << std::hex << product;
  EXPECT_EQ(SpaceMouseOf(MultiAxis(0x046d, 0xc52b)), nullptr); // a receiver of Logitech's mice
  EXPECT_EQ(SpaceMouseOf(MultiAxis(0x1234, 0xc635)), nullptr);
}

TEST(SpaceMouseModels, OfTheReceiverTheMouseIsSkipped)
{
  const auto receiver = [](const char* name)
  { return SpaceMouseOf(MultiAxis(0x256f, 0xc652, name)); };
  EXPECT_NE(receiver("3Dconnexion Universal Receiver"), nullptr);
  EXPECT_NE(receiver("SpaceMouse Universal Receiver"), nullptr); // no mouse in that word
  EXPECT_NE(receiver("Mousepad"), nullptr);
  EXPECT_EQ(receiver("3Dconnexion Universal Receiver Mouse"), nullptr);
  EXPECT_EQ(receiver("Mouse"), nullptr);
  EXPECT_EQ(receiver("SpaceMouse Mouse"), nullptr);
}

TEST(SpaceMouseModels, OnesThatNoListKnowsAreTaken)
{
  const SpaceMouseModel* const model = SpaceMouseOf(MultiAxis(0x256f, 0xc6ff));
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(SpaceMouseButtons(*model, 0x8000'0001u), 0x8000'0001u);
}

TEST(SpaceMouseModels, EachButtonIsOneBitAndNoOther)
{
  for (const SpaceMouseModel& model : SpaceMouseModels())
  {
    ASSERT_LE(model.buttonBits.size(), 32u) << model.name;
    std::uint64_t listed = 0;
    for (std::size_t n = 0; n < model.buttonBits.size(); ++n)
    {
      ASSERT_LT(model.buttonBits[n], 48) << model.name;
      const std::uint64_t bit = std::uint64_t{ 1 } << model.buttonBits[n];
      EXPECT_EQ(listed & bit, 0u) << model.name << " " << n;
      listed |= bit;
      EXPECT_EQ(SpaceMouseButtons(model, bit), 1u << n) << model.name;
    }
    EXPECT_EQ(SpaceMouseButtons(model, ~listed), 0u) << model.name;
    EXPECT_EQ(std::popcount(SpaceMouseButtons(model, ~std::uint64_t{ 0 })),
      static_cast<int>(model.buttonBits.size()));
  }
}

/// By hand from the published table: byte 2, bit 4 is the Pro's key 1; byte 4, bit 1 its Ctrl.
TEST(SpaceMouseModels, ScatteredButtonsLieWhereTheyAreListed)
{
  const SpaceMouseModel* const pro = SpaceMouseOf(MultiAxis(0x046d, 0xc62b));
  ASSERT_NE(pro, nullptr);
  EXPECT_EQ(SpaceMouseButtons(*pro, 0x00'00'10'00u), 1u);
  EXPECT_EQ(SpaceMouseButtons(*pro, 0x02'00'00'00u), 1u << 13);
  EXPECT_EQ(SpaceMouseButtons(*pro, 0x00'00'00'01u), 1u << 4); // Menu
}

} // namespace
