// The choice between tracing and rasterising, by times that are made up.
#include "RendererChoice.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

TEST(RendererChoice, TakesTheFasterOne)
{
  for (const bool traceIsFaster : { true, false })
  {
    hasp::RendererChoice choice;
    EXPECT_EQ(choice.Text(), "traced: OpenGL is software, so rays are tried first");
    for (const double milliseconds : { 95.0, 20.0 })
    {
      EXPECT_TRUE(choice.Trace(1000, 100));
      choice.Note(milliseconds);
    }
    EXPECT_EQ(
      choice.Text(), "traced: OpenGL is software, so rays are tried first; they took 20.0 ms");
    for (const double milliseconds : { 90.0, 60.0, traceIsFaster ? 21.0 : 19.0 })
    {
      EXPECT_FALSE(choice.Decided());
      EXPECT_FALSE(choice.Trace(1000, 100));
      choice.Note(milliseconds);
      if (!choice.Decided())
      {
        EXPECT_EQ(choice.Text().rfind("rasterised: to compare; traced in 20.0 ms, ", 0), 0U);
      }
    }
    EXPECT_TRUE(choice.Decided());
    EXPECT_EQ(choice.Trace(1000, 100), traceIsFaster);
    EXPECT_EQ(choice.MayTrace(), traceIsFaster);
    EXPECT_EQ(choice.Text(), traceIsFaster
                               ? "traced: traced in 20.0 ms, rasterised in 21.0 ms"
                               : "rasterised: traced in 20.0 ms, rasterised in 19.0 ms");
  }
}

TEST(RendererChoice, DoesNotWaitForWhatTakesForEver)
{
  hasp::RendererChoice choice;
  for (const double milliseconds : { 95.0, 20.0 })
  {
    EXPECT_TRUE(choice.Trace(1000, 100));
    choice.Note(milliseconds);
  }
  EXPECT_FALSE(choice.Trace(1000, 100));
  choice.Note(1081);
  EXPECT_TRUE(choice.Decided());
  EXPECT_TRUE(choice.Trace(1000, 100));
}

TEST(RendererChoice, TheSecondRasterisedFrameDecidesWhereItIsFarSlower)
{
  for (const bool far : { false, true })
  {
    hasp::RendererChoice choice;
    for (const double milliseconds : { 95.0, 20.0, 500.0, far ? 81.0 : 80.0 })
    {
      EXPECT_FALSE(choice.Decided());
      choice.Trace(1000, 100);
      choice.Note(milliseconds);
    }
    EXPECT_EQ(choice.Decided(), far);
    EXPECT_EQ(choice.Trace(1000, 100), far);
  }
}

TEST(RendererChoice, HoldsUntilTheSceneIsAnother)
{
  const auto decided = []
  {
    hasp::RendererChoice choice;
    for (const double milliseconds : { 20.0, 20.0, 9.0, 9.0, 9.0 })
    {
      choice.Trace(1000, 100);
      choice.Note(milliseconds);
    }
    return choice;
  };
  for (const auto& [cells, pixels, holds] : { std::tuple(2000, 200, true), { 500, 50, true },
         { 2001, 100, false }, { 499, 100, false }, { 1000, 201, false }, { 1000, 49, false } })
  {
    hasp::RendererChoice choice = decided();
    EXPECT_EQ(choice.Trace(cells, pixels), !holds) << cells << " " << pixels;
    EXPECT_EQ(choice.Decided(), holds) << cells << " " << pixels;
  }
}

} // namespace
