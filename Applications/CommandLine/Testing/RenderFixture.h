#pragma once
#include "HaspProcess.h"

using Words = std::vector<std::string>;

/// Draws the phantom into a small picture.
class RenderFixture : public HaspTest
{
protected:
  HaspRun Render(const Words& more, const std::string& output = "out.png") const
  {
    Words words{ "render", this->Path("head.mha"), "--isovalue", "226", "--resolution", "120,90",
      "--output", this->Path(output) };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
};
