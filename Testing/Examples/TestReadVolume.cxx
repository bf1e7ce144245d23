#include "ExampleRun.h"

namespace
{

class ReadVolume : public ExampleTest
{
};

TEST_F(ReadVolume, WritesWhatItReads)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("ReadVolume ball.mha ball.nrrd"), 0) << this->said;
  EXPECT_NE(this->said.find("MetaImage, int16, the file does not say HU"), std::string::npos)
    << this->said;
  const std::string first = this->said.substr(this->said.find("hash"));
  ASSERT_EQ(this->Run("ReadVolume ball.nrrd again.mha"), 0) << this->said;
  EXPECT_NE(this->said.find(first), std::string::npos) << this->said; // one volume, one hash
}

TEST_F(ReadVolume, WhatIsRefusedIsAFaultAndNoFile)
{
  ASSERT_EQ(this->Shell("mkdir slices && echo text > slices/note.txt"), 0);
  EXPECT_EQ(this->Run("ReadVolume slices out.nrrd"), 1);
  EXPECT_NE(this->said.find("fault: "), std::string::npos) << this->said;
  EXPECT_FALSE(std::filesystem::exists(this->Path("out.nrrd")));
}

} // namespace
