#include "vtkHaspStereoPair.h"

#include "vtkInformation.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

namespace
{

TEST(StereoPair, IsWhatWasSetAndNothingInMono)
{
  EXPECT_FALSE(hasp::StereoPairOf(nullptr));
  vtkNew<vtkInformation> information, other;
  EXPECT_FALSE(hasp::StereoPairOf(information));
  hasp::StereoPair pair;
  for (int n = 0; n < 16; ++n)
  {
    pair.left[n / 4][n % 4] = 1.0 / (n + 3);
    pair.right[n / 4][n % 4] = -1e-17 * n;
  }
  hasp::SetStereoPair(information, pair);
  const auto read = hasp::StereoPairOf(information);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->left, pair.left);
  EXPECT_EQ(read->right, pair.right);
  other->Copy(information); // as cameras are copied
  EXPECT_TRUE(hasp::StereoPairOf(other));
  hasp::SetStereoPair(information, std::nullopt);
  EXPECT_FALSE(hasp::StereoPairOf(information));
  EXPECT_EQ(information->GetNumberOfKeys(), 0);
  EXPECT_TRUE(hasp::StereoPairOf(other));
}

} // namespace
