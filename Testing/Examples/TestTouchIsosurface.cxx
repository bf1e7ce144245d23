#include "ExampleRun.h"

namespace
{

class TouchIsosurface : public ExampleTest
{
};

TEST_F(TouchIsosurface, NothingToTouchIsAFailure)
{
  EXPECT_EQ(this->Run("TouchIsosurface no.mha 0"), 1) << this->said;
}

// A copy in hand beside the ball that is read, half in it: points touch.
TEST_F(TouchIsosurface, ABallIsFelt)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("TouchIsosurface ball.mha 0"), 0) << this->said;
  EXPECT_NE(this->said.find(" points touch"), std::string::npos) << this->said;
  EXPECT_GT(std::stoi(this->said.substr(this->said.find("\n") + 1)), 0) << this->said;
}

} // namespace
