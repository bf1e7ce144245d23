#include "ExampleRun.h"

namespace
{

class KeepIsosurface : public ExampleTest
{
};

TEST_F(KeepIsosurface, WritesCellsAndFollowsAnEdit)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("KeepIsosurface ball.mha 0 ball.hcells"), 0) << this->said;
  EXPECT_TRUE(std::filesystem::exists(this->Path("ball.hcells")));
  const auto comma = this->said.find(", ");
  ASSERT_NE(comma, std::string::npos) << this->said;
  // A single sample inside makes the 8 cells around it active.
  EXPECT_EQ(std::stoi(this->said.substr(comma + 2)), std::stoi(this->said) + 8) << this->said;
}

TEST_F(KeepIsosurface, WhatIsRefusedIsNoFile)
{
  EXPECT_EQ(this->Run("KeepIsosurface none.mha 0 out.hcells"), 1);
  EXPECT_FALSE(std::filesystem::exists(this->Path("out.hcells")));
}

} // namespace
