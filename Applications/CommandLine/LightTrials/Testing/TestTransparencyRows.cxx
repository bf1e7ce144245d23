// The rows of translucent layers as the report has them, and the ways apart.
#include "LayerPicture.h"
#include "ReportRegistry.h"
#include "TransparencyTrial.h"
#include "vtkHaspHeadlessWindows.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

namespace
{

using namespace hasp;

class Transparency : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { UseHeadlessWindows(); }
};

TEST_F(Transparency, RowsTellPeelingFromWhatIsNotSorted)
{
  Report report;
  report.name = "light";
  report.terms = { { "light.transparency", "as the report explains it" } };
  ReportContext context{ report, {}, [](double, const std::string&) {} };
  context.settings.quick = true;
  MeasureLayers(context, 4);
  for (const std::string& fault : ReportFaults(report))
    ADD_FAILURE() << fault;
  std::map<std::string, double> values;
  for (const ReportRow& row : report.rows)
  {
    EXPECT_FALSE(Missed(row)) << row.id;
    values[row.id.substr(std::string("light.transparency.").size())] = *row.value;
  }
  EXPECT_EQ(values.size(), report.rows.size());
  EXPECT_EQ(values.size(), 8U);
  EXPECT_LE(values.at("rms.peeled@4"), values.at("max.peeled@4"));
  // Neither sorts: layers of half a colour in another order are tens of levels off.
  EXPECT_GT(values.at("max.weighted@4"), 20.0);
  EXPECT_GT(values.at("max.unsorted@4"), 20.0);
}

TEST_F(Transparency, PicturesOfOtherNumbersOfLayersAreRefused)
{
  for (const int layers : { -2, 2, 5, 14 })
    EXPECT_THROW(LayerPicture{ layers }, std::invalid_argument) << layers;
}

} // namespace
