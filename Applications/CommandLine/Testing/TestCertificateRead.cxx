// What a certificate says after it was kept as JSON: the same, and nothing that others wrote.
#include "CertificatePage.h"
#include "CertificateRead.h"
#include "CertificateTable.h"
#include "CertificateText.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace hasp
{
namespace
{

/// With all that a certificate can have; no two figures alike, so that none can stand for another.
FitCertificate Full()
{
  FitCertificate c;
  c.claims.isovalue = 300.5;
  c.claims.leastWallMm = 0.7;
  c.claims.leastUncutMm = 0.9;
  c.claims.shell = ClaimedShell{ 0.31, 0.21, 0.94, 2.6, 0.41 };
  c.claims.slots.push_back({ .widthMm = 1.1, .toleranceMm = 0.12 });
  c.claims.holes.push_back({ .diameterMm = 2.1, .toleranceMm = 0.13, .name = "screws[2]" });
  c.claims.withdrawal = glm::dvec3(0.0, 0.6, 0.8);
  c.mesh = { .points = 11,
    .triangles = 12,
    .borderEdges = 1,
    .crowdedEdges = 2,
    .turnedEdges = 3,
    .pinchedPoints = 4,
    .degenerate = 5,
    .pieces = 1,
    .volumeMm3 = 6.5,
    .areaMm2 = 7.5 };
  c.pieces = { { 12, 6.5, { -1, -2, -3 }, { 1, 2, 3 } } };
  c.low = { -1, -2, -3 };
  c.high = { 4, 5, 6 };
  c.slivers = 8;
  c.selfIntersections = 9;
  c.wall = { 10.5, 0.71, { 1, 0, 0 }, 0.72, 0.73 };
  c.uncut = WallThickness{ 11.5, 0.91, { 0, 1, 0 }, 0.92, 0.93 };
  c.gap = GuideGap{ 12.5, 0.95, 0.01, 0.2, 0.25, 0.3, 0.35, 0.4, 0.19, { 0, 0, 1 }, { 1, 1, 0 },
    { 1.0, 2.0, 3.0, 4.0 } };
  c.shell = ShellThickness{ 13.5, 2.3, { 0, 1, 1 }, 2.4, 2.5 };
  c.slots.push_back({ 14, 1.01, { 2, 0, 0 }, 1.02, 0.03, 0.04, 0.05, 15.5, 16.5, std::nullopt });
  c.holes.push_back(
    { 17, 0.99, 18.5, 2.01, 2.02, 0.06, 0.07, 0.08, { 0, 2, 0 }, glm::dvec3(0, 0, 2) });
  c.insertion = Insertion{ 19, 20, 21.5, 0.22, { 3, 0, 0 }, { 0, 3, 0 } };
  return c;
}

std::string PageOf(const FitCertificate& c)
{
  return CertificateHtml(c, {}) + CertificateText(c);
}

/// Whatever key of it is missing or of another type: an error without a text of it.
void ExpectRefused(const nlohmann::ordered_json& json, const std::string& what)
{
  try
  {
    ReadCertificate(json);
    ADD_FAILURE() << what;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()).find("Erika"), std::string::npos) << what;
  }
}

TEST(CertificateRead, WhatIsNoneIsRefusedWithoutATextOfIt)
{
  const nlohmann::ordered_json good = CertificateJson(Full());
  for (const char* key :
    { "format", "mesh", "walls", "gap", "slots", "holes", "insertion", "faults", "isovalue" })
  {
    nlohmann::ordered_json bad = good;
    bad[key] = "Erika";
    ExpectRefused(bad, key);
    bad.erase(key);
    ExpectRefused(bad, key);
  }
  EXPECT_THROW(CertificateOfReport("Erika"), std::runtime_error);
  EXPECT_FALSE(CertificateOfReport("{}"));
}

TEST(CertificateRead, SaysWhatItSaidBefore)
{
  const FitCertificate c = Full();
  EXPECT_EQ(PageOf(ReadCertificate(CertificateJson(c))), PageOf(c));
  FitCertificate bare = c; // and where nothing was claimed or found
  bare.claims = {};
  bare.gap.reset();
  bare.shell.reset();
  bare.uncut.reset();
  bare.selfIntersections.reset();
  bare.insertion.reset();
  bare.slots.clear();
  bare.holes.clear();
  EXPECT_EQ(PageOf(ReadCertificate(CertificateJson(bare))), PageOf(bare));
  FitCertificate far = c; // no bone within reach of any wall
  far.gap->leastAnywhere = HUGE_VAL;
  EXPECT_EQ(PageOf(ReadCertificate(CertificateJson(far))), PageOf(far));
}

TEST(CertificateRead, KeepsFaultsPlacesInWordsOfOurs)
{
  FitCertificate c = Full();
  c.faults = { { FitFaultKind::Slot, "slots[0] Erika", glm::dvec3(1, 2, 3) },
    { FitFaultKind::ThinWall, "Erika", std::nullopt } };
  const FitCertificate read = ReadCertificate(CertificateJson(c));
  ASSERT_EQ(read.faults.size(), 2U);
  EXPECT_EQ(read.faults[0].kind, FitFaultKind::Slot);
  EXPECT_EQ(read.faults[0].at, glm::dvec3(1, 2, 3));
  EXPECT_EQ(read.faults[0].text, "slots[0]: a slot is not as claimed at (1.0, 2.0, 3.0) mm");
  EXPECT_EQ(read.faults[1].kind, FitFaultKind::ThinWall);
  EXPECT_FALSE(read.faults[1].at);
  EXPECT_EQ(PageOf(read).find("Erika"), std::string::npos);
}

} // namespace
} // namespace hasp
