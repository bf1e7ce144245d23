// Implants through the filter and their file, held to what they promise.
#include "Evaluation/FitCertificate.h"
#include "FilterFixture.h"
#include "GuideFixture.h"
#include "ImplantClaims.h"
#include "ImplantFixture.h"
#include "vtkHaspImplantFilter.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include "vtkDataArray.h"
#include "vtkFieldData.h"

using namespace implanttest;

namespace
{

const Scan& Head()
{
  static const Scan scan(1.0);
  return scan;
}

hasp::ImplantRecipe Perforated()
{
  hasp::ImplantRecipe recipe = AroundTheHole(Head());
  recipe.mirror.reset();
  recipe.axis.reset();
  recipe.holeDiameterMm = 2.0;
  recipe.holePitchMm = 8.0;
  return recipe;
}

struct ImplantAnswer
{
  vtkNew<vtkHaspImplantFilter> filter;
  vtkSmartPointer<vtkImageData> ct = hasp::MakeImage(Head().grid, Head().samples);
  std::string error;

  explicit ImplantAnswer(const hasp::ImplantRecipe& recipe)
  {
    parttest::KeepWords(this->filter, this->error);
    this->filter->SetInputData(this->ct);
    this->filter->SetRecipe(recipe);
    this->filter->Update();
  }
  /// Of one of its arrays.
  std::vector<glm::dvec3> Vectors(const char* name)
  {
    vtkDataArray* array = this->filter->GetOutput()->GetFieldData()->GetArray(name);
    std::vector<glm::dvec3> vectors;
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
    {
      const double* tuple = array->GetTuple(n);
      vectors.emplace_back(tuple[0], tuple[1], tuple[2]);
    }
    return vectors;
  }
};

hasp::FindSelfIntersectionsFunction SelfIntersections()
{
#if HASP_WITH_CGAL
  return hasp::FindSelfIntersections;
#else
  return [](const hasp::TriangleMesh&)
  { return std::vector<std::array<std::uint32_t, 2>>(); }; // not what these tests are about
#endif
}

std::string FaultsOf(const hasp::FitCertificate& certificate)
{
  std::string text;
  for (const hasp::FitFault& fault : certificate.faults)
    text += fault.text + "\n";
  return text;
}

TEST(ImplantFilter, TheFileHoldsWhatTheRecipePromises)
{
  ImplantAnswer answer(Perforated());
  ASSERT_EQ(answer.error, "");
  const auto holes = answer.Vectors("Holes");
  const glm::dvec3 axis = answer.Vectors("Axis")[0];
  EXPECT_GT(holes.size(), 8U);
  EXPECT_GT(glm::dot(axis, Head().Hole().outward), 0.97); // upright on the outline
  const hasp::PartClaims claims = hasp::ClaimsOf(Perforated(), axis, holes);
  const hasp::TriangleMesh mesh = guidetest::ThroughFile(answer.filter->GetOutput());
  const auto certificate = hasp::CertifyFit(mesh, Head().View(), claims, SelfIntersections());
  EXPECT_TRUE(certificate.Holds()) << FaultsOf(certificate);
  EXPECT_NEAR(certificate.wall.p50Mm, Perforated().thicknessMm, 0.05);
  ASSERT_TRUE(certificate.insertion);
  EXPECT_EQ(certificate.insertion->blocked, 0U);
  vtkDataArray* rim = answer.filter->GetOutput()->GetFieldData()->GetArray("Rim");
  EXPECT_LT(rim->GetTuple(0)[3], 0.3); // on bone that is symmetric
}

TEST(ImplantFilter, WhatDoesNotKeepThePromiseIsFound)
{
  ImplantAnswer answer(Perforated());
  ASSERT_EQ(answer.error, "");
  const glm::dvec3 axis = answer.Vectors("Axis")[0];
  const hasp::TriangleMesh mesh = guidetest::ThroughFile(answer.filter->GetOutput());
  const auto faults = [&](const hasp::PartClaims& claims, const hasp::TriangleMesh& part)
  { return FaultsOf(hasp::CertifyFit(part, Head().View(), claims, SelfIntersections())); };
  const hasp::PartClaims claims = hasp::ClaimsOf(Perforated(), axis, answer.Vectors("Holes"));
  hasp::PartClaims thicker = claims;
  thicker.leastWallMm = Perforated().thicknessMm + 0.3;
  EXPECT_NE(faults(thicker, mesh).find("a wall is"), std::string::npos);
  // Pushed into the hole's edge by more than its clearance.
  hasp::TriangleMesh pushed = mesh;
  for (glm::dvec3& p : pushed.points)
    p += 1.0 * Head().Hole().along;
  const std::string said = faults(claims, pushed);
  EXPECT_NE(said.find("cannot be put on along its axis"), std::string::npos) << said;
  EXPECT_NE(said.find("holes[0]"), std::string::npos) << said;
}

TEST(ImplantFilter, SaysWhatCannotBeMadeAndLeavesNothing)
{
  hasp::ImplantRecipe recipe = Perforated();
  recipe.outline[2] = { 0, 0, 0 };
  ImplantAnswer answer(recipe);
  EXPECT_NE(answer.error.find("implant: outline[2] ("), std::string::npos) << answer.error;
  EXPECT_EQ(answer.filter->GetOutput()->GetNumberOfPolys(), 0);
}

} // namespace
