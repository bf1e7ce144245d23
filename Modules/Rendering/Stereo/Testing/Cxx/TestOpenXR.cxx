#include "vtkHaspOpenXR.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

// Built where it is not there. Where it is, VTK's own tests need a runtime; so would ours.
TEST(OpenXR, SaysWhatItTakes)
{
  const std::string why = hasp::WhyNoOpenXR();
  EXPECT_NE(why.find("RenderingOpenXR"), std::string::npos);
  EXPECT_NE(why.find("9.2"), std::string::npos);
  try
  {
    hasp::MakeOpenXRView();
    FAIL() << "there is none";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(error.what(), why);
  }
}

} // namespace
