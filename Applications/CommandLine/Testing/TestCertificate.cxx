// What is said of a certificate, and what pictures of one show, without bin/hasp around it.
#include "BoneAround.h"
#include "CertificatePage.h"
#include "CertificateTable.h"
#include "GapColours.h"
#include "PartCertificate.h"
#include "Session.h"
#include "Version.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <new>
#include <streambuf>

namespace hasp // of the program; no clock and no commit in a test
{
const char* Version()
{
  return "0";
}
const char* Commit()
{
  return "0";
}
} // namespace hasp

namespace
{

/// A box around the origin, of that half size.
hasp::TriangleMesh Box(double half)
{
  hasp::TriangleMesh mesh;
  for (unsigned n = 0; n < 8; ++n)
    mesh.points.emplace_back(n & 1 ? half : -half, n & 2 ? half : -half, n & 4 ? half : -half);
  mesh.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return mesh;
}

class Certificate : public testing::Test
{
protected:
  hasp::GridGeometry grid{ { 20, 20, 20 }, glm::dvec3(-10.0), glm::dvec3(1.0), glm::dmat3(1.0) };
  std::vector<float> air = std::vector<float>(8000, 0.0F);

  hasp::AnyGridView Air() const
  {
    return hasp::GridView<const float>{ this->air.data(), this->grid };
  }
  hasp::FitCertificate Of(const hasp::TriangleMesh& mesh, const hasp::PartClaims& claims = {}) const
  {
    return hasp::CertifyFit(mesh, this->Air(), claims,
      [](const hasp::TriangleMesh&) { return std::vector<std::array<std::uint32_t, 2>>(); });
  }
  static std::string RowOf(const hasp::FitCertificate& certificate, const std::string& measure)
  {
    const std::string page = hasp::CertificateHtml(certificate, {});
    const std::size_t at = page.find("<tr><td>" + measure);
    return at == page.npos ? "" : page.substr(at, page.find("</tr>", at) - at);
  }
};

TEST_F(Certificate, WhatWasNotMeasuredIsNotShownToHold)
{
  EXPECT_NE(RowOf(this->Of(Box(3)), "pairs of triangles").find(">holds<"), std::string::npos);
  hasp::TriangleMesh crowded = Box(3); // three triangles at an edge: it cannot be told
  crowded.points.emplace_back(0, -9, -9);
  crowded.triangles.emplace_back(0, 1, 8);
  const std::string row = RowOf(this->Of(crowded), "pairs of triangles");
  EXPECT_NE(row.find("<td class=\"faint\">not measured</td>"), std::string::npos) << row;
  hasp::PartClaims claims;
  claims.shell = hasp::ClaimedShell{};
  const hasp::FitCertificate inAir = this->Of(Box(3), claims); // nothing of it faces bone
  for (const char* measure : { "shell, least", "nearest to bone" })
    EXPECT_EQ(RowOf(inAir, measure).find(">holds<"), std::string::npos) << measure;
  EXPECT_NE(RowOf(this->Of({}), "pieces").find(">does not hold<"), std::string::npos);
}

TEST_F(Certificate, WithoutARecipeTheMeshAloneIsSound)
{
  const std::string mesh = hasp::CertificateHtml(this->Of(Box(3)), {});
  EXPECT_EQ(mesh.find("The part holds"), std::string::npos);
  EXPECT_NE(mesh.find("<h1 class=\"unheld\">The mesh is sound; not held to a recipe</h1>"),
    std::string::npos);
  EXPECT_NE(mesh.find("There was no recipe to hold the part to"), std::string::npos);
  hasp::PartClaims claims; // an implant's, say: no gap
  claims.withdrawal = glm::dvec3(0, 0, 1);
  const std::string implant = hasp::CertificateHtml(this->Of(Box(3), claims), {});
  EXPECT_NE(implant.find("<h1 class=\"good\">The part holds</h1>"), std::string::npos);
  EXPECT_EQ(implant.find("no recipe"), std::string::npos);
  EXPECT_NE(implant.find("The gap to the bone is not claimed"), std::string::npos);
}

/// Memory runs out as soon as something is written to it.
struct Exhausted : std::streambuf
{
  int overflow(int) override { throw std::bad_alloc(); }
};

TEST_F(Certificate, BadClaimsAndMemoryAreNoFaultOfThePart)
{
  hasp::Session session;
  session.progress.SetStyle(hasp::ProgressLine::Style::Quiet);
  hasp::PartClaims claims;
  claims.leastWallMm = -1.0;
  try
  {
    hasp::MeasurePart(Box(3), this->Air(), claims, session);
    ADD_FAILURE() << "was measured";
  }
  catch (const hasp::Failure& failure)
  {
    EXPECT_EQ(failure.code, hasp::ExitCode::BadInput);
    EXPECT_STREQ(failure.what(), "claims: leastWallMm is -1, must be from 0 to 50");
  }
  Exhausted exhausted;
  std::ostream* const tied = std::cerr.tie(nullptr);
  session.progress.Step("measuring");
  session.progress.SetStyle(hasp::ProgressLine::Style::Terminal);
  std::streambuf* const before = std::cerr.rdbuf(&exhausted);
  const auto mask = std::cerr.exceptions();
  std::cerr.exceptions(std::ios::badbit);
  EXPECT_THROW(hasp::MeasurePart(Box(3), this->Air(), {}, session), std::bad_alloc);
  std::cerr.exceptions(std::ios::goodbit);
  std::cerr.rdbuf(before);
  std::cerr.clear();
  std::cerr.exceptions(mask);
  std::cerr.tie(tied);
}

TEST_F(Certificate, TheGapsColoursTellItsLimits)
{
  const hasp::ClaimedShell shell; // 0.3 within 0.2
  const auto differ = [&](double a, double b)
  {
    const hasp::Colour one = hasp::GapColour(shell, a), other = hasp::GapColour(shell, b);
    int most = 0;
    for (std::size_t n = 0; n < one.size(); ++n)
      most = std::max(most, std::abs(int(one[n]) - int(other[n])));
    return most;
  };
  for (const double side : { -1.0, 1.0 })
  {
    EXPECT_GT(differ(0.3, 0.3 + side * 0.02), 60); // guides are as true as that
    EXPECT_GT(differ(0.3, 0.3 + side * 0.05), 140);
    EXPECT_GT(differ(0.3 + side * 0.05, 0.3 + side * 0.10), 50);
    EXPECT_GT(differ(0.3 + side * 0.199, 0.3 + side * 0.201), 80); // in, and out
    EXPECT_EQ(differ(0.3 + side * 0.3, 0.3 + side * 5.0), 0);
  }
  EXPECT_GT(differ(0.0, 0.6), 80);
  EXPECT_GT(differ(0.15, 0.45), 80);
  const std::string scale = hasp::GapScaleSvg(shell);
  for (const char* tick : { ">0.10 mm<", ">0.20 mm<", ">0.30 mm<", ">0.40 mm<", ">0.50 mm<" })
    EXPECT_NE(scale.find(tick), std::string::npos) << tick;
}

TEST_F(Certificate, PicturesShowTheBoneAroundThePartAlone)
{
  hasp::GridGeometry whole = this->grid;
  whole.dims = { 60, 40, 30 };
  whole.spacing = { 2, 2, 2 };
  std::vector<float> samples(whole.Size(), 0.0F);
  const auto at = [&](int i, int j, int k) -> float& { return samples[(k * 40 + j) * 60 + i]; };
  for (int i = 10; i < 20; ++i)
    for (int j = 10; j < 20; ++j)
      at(i, j, 10) = 1000.0F; // bone, 800 mm3, at the part
  at(12, 12, 14) = 1000.0F;   // a speck beside it
  for (int j = 0; j < 40; ++j)
    at(50, j, 10) = 1000.0F; // a head-rest
  const auto bone = hasp::MakeImage(whole, samples);
  const glm::dvec3 low = whole.IndexToWorld({ 11, 11, 10 }),
                   high = whole.IndexToWorld({ 18, 18, 12 });
  const auto around = hasp::BoneAround(bone, {}, low, high, 20.0);
  const hasp::AnyGridView view = hasp::ViewImage(around);
  const hasp::GridGeometry& g = hasp::GeometryOf(view);
  EXPECT_EQ(g.dims, glm::ivec3(28, 28, 23));
  std::size_t bony = 0;
  for (std::size_t n = 0; n < g.Size(); ++n)
    bony += std::get<hasp::GridView<const float>>(view).data[n] >= 226.0F;
  EXPECT_EQ(bony, 100U); // in its place:
  const glm::dvec3 index = g.WorldToIndex(whole.IndexToWorld({ 10, 10, 10 }));
  const auto sample = std::size_t((index.z * g.dims.y + index.y) * g.dims.x + index.x + 0.5);
  EXPECT_EQ(std::get<hasp::GridView<const float>>(view).data[sample], 1000.0F);
  EXPECT_EQ(std::get<hasp::GridView<const float>>(view).data[sample - 1], 0.0F);
  // Of a part that lies elsewhere all is shown.
  EXPECT_EQ(hasp::BoneAround(bone, {}, glm::dvec3(900), glm::dvec3(901), 20.0), bone);
}

} // namespace
